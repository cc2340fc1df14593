// Tests of 14-octree.
#include <stdlib.h>
#include <string.h>

#include "tests/14-octree-overlap.h"
#include "tests/14-octree-walk.h"

// ---- child_of ----------------------------------------------------------------------------

static int child_by_hand(vec3 p, vec3 middle) {
    int child = 0;
    if (!(p.x < middle.x)) child += 1;
    if (!(p.y < middle.y)) child += 2;
    if (!(p.z < middle.z)) child += 4;
    return child;
}

// What a slip makes of the three comparisons.
static const struct {
    const char *looks_like, *hint;
    int weight[3];     // of x, y and z
    int flipped;       // axes whose lower half is taken for the upper one
    bool strict, adds; // > for >=; + for |
} child_slips[] = {
    {"the other half along each axis",
     "A bit is 1 in the upper half: p.x >= middle.x.",
     {1, 2, 4},
     7,
     false,
     false},
    {"the other half along x",
     "A bit is 1 in the upper half, also along x.",
     {1, 2, 4},
     1,
     false,
     false},
    {"the other half along y",
     "A bit is 1 in the upper half, also along y.",
     {1, 2, 4},
     2,
     false,
     false},
    {"the other half along z",
     "A bit is 1 in the upper half, also along z.",
     {1, 2, 4},
     4,
     false,
     false},
    {"a point on the plane put into the lower half",
     "On the plane: the upper half, >=.",
     {1, 2, 4},
     0,
     true,
     false},
    {"bit 0 taken for z and bit 2 for x",
     "Bit 0 is x, bit 1 is y, bit 2 is z.",
     {4, 2, 1},
     0,
     false,
     false},
    {"bits 0 and 1, x and y, swapped",
     "Bit 0 is x, bit 1 is y, bit 2 is z.",
     {2, 1, 4},
     0,
     false,
     false},
    {"bits 1 and 2, y and z, swapped",
     "Bit 0 is x, bit 1 is y, bit 2 is z.",
     {1, 4, 2},
     0,
     false,
     false},
    {"all three in bit 0",
     "Bit 0 is x; the one for y is shifted by 1, the one for z by 2.",
     {1, 1, 1},
     0,
     false,
     false},
    {"1, 2 and 3 in place of 1, 2 and 4",
     "Bit 2 is worth 4: 1 << 2.",
     {1, 2, 3},
     0,
     false,
     true},
    {"z shifted by 3", "Bits 0, 1 and 2: z is shifted by 2.", {1, 2, 8}, 0, false, false},
    {"one bit too far to the left",
     "Bits 0, 1 and 2: x is not shifted.",
     {2, 4, 8},
     0,
     false,
     false},
};

static int child_with_slip(int slip, vec3 p, vec3 m) {
    const bool strict = child_slips[slip].strict;
    const int upper[3] = {strict ? p.x > m.x : p.x >= m.x, strict ? p.y > m.y : p.y >= m.y,
                          strict ? p.z > m.z : p.z >= m.z};
    int child = 0;
    for (int axis = 0; axis < 3; axis++) {
        const int bit = upper[axis] ^ (child_slips[slip].flipped >> axis & 1);
        const int part = bit * child_slips[slip].weight[axis];
        child = child_slips[slip].adds ? child + part : child | part;
    }
    return child;
}

// A point, with some coordinates in the dividing planes when i says so.
static vec3 child_point(int i, vec3 middle, rng *g) {
    const vec3 q = in_cube(g);
    return (vec3){i & 1 ? middle.x : q.x, i & 2 ? middle.y : q.y, i & 4 ? middle.z : q.z};
}

// The slip that explains all answers, of generic points and of points in planes; or -1.
static int child_slip(void) {
    for (int slip = 0; slip < COUNT(child_slips); slip++) {
        rng g = check_rng(1425);
        bool all = true;
        for (int i = 0; i < 400; i++) {
            const vec3 middle = in_cube(&g), p = child_point(i, middle, &g);
            all &= child_of(p, middle) == child_with_slip(slip, p, middle);
        }
        if (all) return slip;
    }
    return -1;
}

static void check_child(vec3 p, vec3 middle) {
    const int right = child_by_hand(p, middle);
    given("the point " VEC ", a cell divided at " VEC, ARG(p), ARG(middle));
    const int got = child_of(p, middle);
    if (got == right) return;
    const int slip = child_slip();
    if (slip >= 0) {
        suspect_value(child_slips[slip].looks_like, got);
        hint_instead(child_slips[slip].hint);
    }
    check_int(__FILE__, __LINE__, "child_of(p, middle)", got, right);
}

static void child_around(void) {
    rng g = check_rng(1401);
    for (int i = 0; i < 2000; i++) {
        const vec3 middle = in_cube(&g), p = in_cube(&g);
        check_child(p, middle);
    }
}

static void child_on_plane(void) {
    rng g = check_rng(1402);
    for (int i = 0; i < 200; i++) {
        const vec3 middle = in_cube(&g), p = child_point(i, middle, &g);
        check_child(p, middle);
    }
}

// ---- child_index ---------------------------------------------------------------------------

static int bits_of(unsigned mask) {
    return stored_before(mask, 32);
}

// What a slip makes of it.
static int index_dense(unsigned mask, int i) {
    return (void)mask, i;
}
static int index_with_itself(unsigned mask, int i) {
    return stored_before(mask, i) + 1;
}
static int index_less_one(unsigned mask, int i) {
    return stored_before(mask, i) - 1;
}
static int index_behind(unsigned mask, int i) {
    return bits_of(mask >> i) - 1;
}
static int index_shifted(unsigned mask, int i) {
    return bits_of(mask >> i);
}
static int index_all(unsigned mask, int i) {
    return (void)i, bits_of(mask);
}
static int index_of_empty(unsigned mask, int i) {
    return i - stored_before(mask, i);
}
static int index_bits_themselves(unsigned mask, int i) {
    return (int)(mask & ((1u << i) - 1));
}
static int index_own_bit(unsigned mask, int i) {
    return (int)(mask >> i & 1);
}
static int index_of_number(unsigned mask, int i) {
    return bits_of(mask & (unsigned)i);
}
static int index_from_top(unsigned mask, int i) {
    return bits_of(mask >> (8 - i));
}
static int index_one_short(unsigned mask, int i) {
    return i ? stored_before(mask, i - 1) : 0;
}

static const struct {
    const char *looks_like, *hint;
    int (*of)(unsigned mask, int i);
} index_slips[] = {
    {"i itself, as if all eight were stored", "Only the bits that are set count, below bit i.",
     index_dense},
    {"child i counted too",
     "Before child i: the bits 0 to i - 1. (1u << i) - 1 has just these.", index_with_itself},
    {"one less: child i taken off though it was not counted",
     "Bit i is not below bit i: nothing is to be taken off.", index_less_one},
    {"the children behind i counted", "Before child i: the bits below, 0 to i - 1.",
     index_behind},
    {"child i and those behind it counted: mask >> i keeps the upper bits",
     "mask >> i drops just the bits that count: mask & ((1u << i) - 1) keeps them.",
     index_shifted},
    {"all children counted", "Only those before child i: mask & ((1u << i) - 1).", index_all},
    {"the children that are not stored counted", "Those that are stored: the bits that are 1.",
     index_of_empty},
    {"the bits below i themselves, as a number", "How many of these bits are 1? Count them.",
     index_bits_themselves},
    {"bit i itself", "Not whether i is stored: how many are stored before it.", index_own_bit},
    {"the bits of mask & i", "i is a number: the bits below bit i are (1u << i) - 1.",
     index_of_number},
    {"the i highest bits counted", "Child 0 is bit 0, the lowest: mask & ((1u << i) - 1).",
     index_from_top},
    {"child i - 1 left out", "Before child i: the bits 0 to i - 1, that one too.",
     index_one_short},
};

// The slip that explains all answers, or -1.
static int index_slip(void) {
    for (int slip = 0; slip < COUNT(index_slips); slip++) {
        bool all = true;
        for (unsigned mask = 0; mask < 256; mask++)
            for (int i = 0; i < 8; i++)
                if (is_stored(mask, i))
                    all &= child_index(mask, i) == index_slips[slip].of(mask, i);
        if (all) return slip;
    }
    return -1;
}

static void index_of_all(void) {
    for (unsigned k = 0; k < 256; k++) {
        const unsigned mask = (173 + 151 * k) % 256; // all, and first one with many bits
        for (int i = 0; i < 8; i++) {
            if (!is_stored(mask, i)) continue;
            char stored[24] = "";
            for (int c = 0; c < 8; c++)
                if (is_stored(mask, c))
                    snprintf(stored + strlen(stored), sizeof stored - strlen(stored), " %d", c);
            given("mask = 0x%02x: the children%s are stored; child %d", mask, stored, i);
            const int got = child_index(mask, i), right = stored_before(mask, i);
            if (got == right) continue;
            const int slip = index_slip();
            if (slip >= 0) {
                suspect_value(index_slips[slip].looks_like, got);
                hint_instead(index_slips[slip].hint);
            }
            check_int(__FILE__, __LINE__, "child_index(mask, i)", got, right);
        }
    }
}

// ---- order_children ------------------------------------------------------------------------

static real direction_along(vec3 d, int axis) {
    return along(d, axis);
}

// Can a ray in the direction d go from cell `from` to cell `to`? When it crosses each plane
// between them in its own direction.
static bool leads(vec3 d, int from, int to) {
    for (int axis = 0; axis < 3; axis++) {
        const int step = (to >> axis & 1) - (from >> axis & 1);
        if (step != 0 && !(step * direction_along(d, axis) > 0)) return false;
    }
    return from != to;
}

static bool is_permutation(const int order[8]) {
    int seen = 0;
    for (int k = 0; k < 8; k++)
        if (order[k] >= 0 && order[k] < 8) seen |= 1 << order[k];
    return seen == 255;
}

// What is wrong with an order of which each child must be one; in words.
static const char *twice_or_never(const int order[8]) {
    static char words[300];
    int times[8] = {0}, wrong = 0;
    words[0] = 0;
    for (int k = 0; k < 8; k++) {
        if (order[k] >= 0 && order[k] < 8)
            times[order[k]]++;
        else
            snprintf(words, sizeof words, "%d is no child", order[k]);
    }
    for (int i = 0; i < 8; i++) {
        const size_t length = strlen(words);
        if (times[i] == 1 || ++wrong > 2) continue;
        snprintf(words + length, sizeof words - length, "%schild %d stands there %s",
                 length ? ", " : "", i,
                 times[i] == 0   ? "never"
                 : times[i] == 2 ? "twice"
                                 : "several times");
    }
    return words;
}

// A pair of children of which the later one comes first; NULL: there is none.
static const char *wrong_pair(vec3 d, const int order[8]) {
    static char words[200];
    for (int k = 0; k < 8; k++)
        for (int i = 0; i < k; i++) {
            if (!leads(d, order[k], order[i])) continue;
            snprintf(
                words, sizeof words,
                "child %d stands before child %d, and in this direction a ray goes from %d "
                "to %d",
                order[i], order[k], order[k], order[i]);
            return words;
        }
    return NULL;
}

// How an answer uses the signs of d, from its orders for all eight of them.
enum { FOLLOWS_X, FOLLOWS_Y, FOLLOWS_Z, REVERSED, NEVER, ALWAYS, MIXED };

// Along the axis: 0, the lower half comes first everywhere; 1, the upper one; 2, as it comes.
static int first_half(const int order[8], int axis) {
    int place[8], upper = 0;
    for (int k = 0; k < 8; k++) place[order[k]] = k;
    for (int i = 0; i < 8; i++)
        if (!(i >> axis & 1)) upper += place[i | 1 << axis] < place[i];
    return upper == 0 ? 0 : upper == 4 ? 1 : 2;
}

static bool uses_of_signs(int use[3]) {
    int half[8][3];
    for (int signs = 0; signs < 8; signs++) {
        int order[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
        order_children((vec3){signs & 1 ? (real)-0.5 : (real)0.5,
                              signs & 2 ? (real)-0.7 : (real)0.7,
                              signs & 4 ? (real)-0.6 : (real)0.6},
                       order);
        if (!is_permutation(order)) return false;
        for (int axis = 0; axis < 3; axis++) half[signs][axis] = first_half(order, axis);
    }
    for (int axis = 0; axis < 3; axis++) {
        use[axis] = MIXED;
        for (int u = FOLLOWS_X; u < MIXED; u++) {
            bool all = true;
            for (int signs = 0; signs < 8; signs++)
                all &= half[signs][axis] == (u < REVERSED    ? signs >> u & 1
                                             : u == REVERSED ? !(signs >> axis & 1)
                                                             : u == ALWAYS);
            if (all) use[axis] = u;
        }
    }
    return true;
}

#define FRONT_TO_BACK "front to back: no ray goes from a later child to an earlier one"

// What to say of an order that is not front to back; the signs come first.
static const char *order_claim(void) {
    static char claim[200];
    int use[3];
    if (!uses_of_signs(use)) return FRONT_TO_BACK;
    bool all[MIXED + 1] = {0};
    for (int u = 0; u <= MIXED; u++) all[u] = use[0] == u && use[1] == u && use[2] == u;
    if (all[REVERSED]) {
        hint_instead("For positive d it is 0 to 7. Where d.x < 0 the upper half along x comes "
                     "first: for every axis yours does the opposite.");
        return "front to back: this order is back to front, all reversed";
    }
    if (all[NEVER]) {
        hint_instead(
            "Where d.x < 0 the upper half along x comes first: bit 0 of each number is "
            "the other one.");
        return "front to back: this is 0 to 7, whatever the signs of d";
    }
    for (int axis = 0; axis < 3; axis++) {
        if (use[axis] == axis) continue;
        const char x = "xyz"[axis];
        if (use[axis] == MIXED) {
            hint_instead("Two children that differ in one bit: the sign of d along that axis "
                         "decides which of them comes first.");
            return FRONT_TO_BACK;
        }
        hint_instead(
            "Bit 0 is x, bit 1 is y, bit 2 is z: where d.x < 0 bit 0 is the other one, "
            "and so for y and z.");
        if (use[axis] == REVERSED)
            snprintf(claim, sizeof claim,
                     "front to back: along %c it is back to front, whatever the sign of d.%c",
                     x, x);
        else if (use[axis] < REVERSED)
            snprintf(claim, sizeof claim,
                     "front to back: along %c the order goes by the sign of d.%c", x,
                     "xyz"[use[axis]]);
        else
            snprintf(
                claim, sizeof claim,
                "front to back: along %c the %s half comes first, whatever the sign of d.%c", x,
                use[axis] == NEVER ? "lower" : "upper", x);
        return claim;
    }
    return FRONT_TO_BACK;
}

// All numbers i ^ mask with a mask of more than three bits, and for other signs too?
static bool has_wide_mask(const int order[8]) {
    int use[3];
    for (int k = 0; k < 8; k++)
        if ((order[k] ^ k) != order[0]) return false;
    return !uses_of_signs(use);
}

// `about_signs`: what the directions of this test have that others have not, should only they fail.
static void check_order(vec3 d, const char *about_signs) {
    int order[10] = {-1, -1, -1, -1, -1, -1, -1, -1, -77, -77};
    given("d = " VEC, ARG(d));
    order_children(d, order);
    given("d = " VEC ": order %d %d %d %d %d %d %d %d", ARG(d), order[0], order[1], order[2],
          order[3], order[4], order[5], order[6], order[7]);
    if (order[8] != -77 || order[9] != -77) hint_instead("order[0] to order[7]: k < 8.");
    CHECK(order[8] == -77 && order[9] == -77, "nothing is written behind order[7]");
    int use[3];
    const bool signs_right =
        uses_of_signs(use) && use[0] == FOLLOWS_X && use[1] == FOLLOWS_Y && use[2] == FOLLOWS_Z;
    hint_instead(signs_right ? about_signs : NULL);
    if (!is_permutation(order)) {
        if (has_wide_mask(order))
            hint_instead(
                "i ^ mask, but the mask has more than the bits 0, 1 and 2. signbit(x) is "
                "not 1 but any number other than 0: signbit(x) != 0, or x < 0. And the "
                "shifts are 0, 1 and 2.");
        else if (!signs_right)
            hint_instead("The numbers 0 to 7, each once: which place does each child get?");
        check_that(__FILE__, __LINE__, twice_or_never(order), false, "each child once, 0 to 7");
    }
    const char *pair = wrong_pair(d, order);
    if (pair) check_that(__FILE__, __LINE__, pair, false, order_claim());
}

static void order_generic(void) {
    rng g = check_rng(1403);
    for (int i = 0; i < 8; i++) {
        const vec3 d = absolute(generic_unit(&g));
        check_order((vec3){i & 1 ? -d.x : d.x, i & 2 ? -d.y : d.y, i & 4 ? -d.z : d.z}, NULL);
    }
    for (int i = 0; i < 500; i++) check_order(in_cube(&g), NULL);
}

static void order_zeros(void) {
    rng g = check_rng(1404);
    static const char *const about =
        "Where no component is 0 all signs are right: 0 or -0 spoils it. No division by "
        "a component, no sign that is neither.";
    for (int i = 0; i < 500; i++) check_order(some_zero(in_cube(&g), &g), about);
    check_order((vec3){0, 0, 0}, about);
}

static void order_uneven(void) {
    rng g = check_rng(1405);
    for (int i = 0; i < 500; i++) {
        const vec3 d = in_cube(&g);
        const double x = between(&g, -30, 30), y = between(&g, -30, 30);
        check_order((vec3){d.x * (real)pow(10, x), d.y * (real)pow(10, y), d.z},
                    "For sizes near 1 all signs are right. The sign decides, not the size: a "
                    "sum of components forgets the small one.");
    }
}

// ---- worth_dividing ------------------------------------------------------------------------

static const octree_options usual = {.leaf_size = 4, .depth = 12, .memory = 16};

// 20 triangles of which 2 or 3 are in each child: far from the limits it pays. So where it is not
// divided the limit is the reason; else the cost.
static void check_limit(octree_options how, int depth, bool worth, const char *hint) {
    static const int inside[8] = {3, 2, 3, 2, 3, 2, 3, 2};
    const octree_options far_off = {.leaf_size = 1, .depth = 19, .memory = 16};
    given(
        "how.leaf_size = %d, how.depth = %d; at depth %d\n20 triangles; in the children 3 2 3 "
        "2 3 2 3 2; dividing costs 8 + 5 = 13, testing all 20",
        how.leaf_size, how.depth, depth);
    const bool got = worth_dividing(how, depth, 20, inside);
    hint_instead(hint);
    if (!got && worth && !worth_dividing(far_off, 2, 20, inside))
        hint_instead("It is not the limit: far from both limits this division does not pay in "
                     "your sum, either. The test \"the cost\" says more.");
    check_bool(__FILE__, __LINE__, "worth_dividing(how, depth, 20, inside)", got, worth);
}

static void worth_limits(void) {
    static const char *const deep =
        "Not at how.depth, nor deeper: depth >= how.depth. Else the "
        "division never ends.";
    static const char *const few =
        "Not with how.leaf_size triangles or fewer: count <= how.leaf_size.";
    octree_options how = usual;
    check_limit(how, 11, true,
                "The last division is that of a cell at depth 11: its children are at 12.");
    check_limit(how, 12, false, deep);
    check_limit(how, 13, false, deep);
    how.leaf_size = 20;
    check_limit(how, 3, false, few);
    how.leaf_size = 21;
    check_limit(how, 3, false, few);
    how.leaf_size = 19;
    check_limit(how, 3, true,
                "20 are more than 19. How many are in a child does not matter here.");
    const int none[8] = {0};
    given("how.leaf_size = 0, how.depth = 9; at depth 0\nno triangle at all");
    hint_instead("0 <= leaf_size, and 0 is not less than 0: nothing is won.");
    CHECK_BOOL(worth_dividing((octree_options){.depth = 9}, 0, 0, none), false);
}

// The sum with a slip, and the answer.
static const struct {
    const char *looks_like, *hint;
    double step, share; // of each child with something in it; of what is inside
    bool all_eight, whole, whole_sum, equal, once;
} worth_slips[] = {
    {.looks_like = "a quarter of what is inside in whole numbers",
     .hint = "5 / 4 is 1 in C: divide by 4.0. Or the sum is an int: a double keeps quarters.",
     .step = 1,
     .share = 0.25,
     .whole = true},
    {.looks_like = "a quarter of the sum in whole numbers",
     .hint = "5 / 4 is 1 in C: divide by 4.0. Or the sum is an int: a double keeps quarters.",
     .step = 1,
     .share = 0.25,
     .whole_sum = true},
    {.looks_like = "the triangles alone: no step counted",
     .hint = "Asking a child costs C_STEP each.",
     .step = 0,
     .share = 0.25},
    {.looks_like = "one step for all children together",
     .hint = "Each child with something in it is asked: C_STEP each.",
     .step = 0,
     .share = 0.25,
     .once = true},
    {.looks_like = "a quarter of the step, too: (C_STEP + C_HIT inside[i]) / 4",
     .hint = "Every child with something in it is asked, always: C_STEP whole. Only its "
             "triangles wait for the ray to pass through.",
     .step = 0.25,
     .share = 0.25},
    {.looks_like = "an eighth of the step and of what is inside",
     .hint = "C_STEP whole for each child asked, and a quarter of C_HIT inside[i].",
     .step = 0.125,
     .share = 0.125},
    {.looks_like = "one step for all children together, and an eighth of what is inside",
     .hint = "C_STEP for each child with something in it, and a quarter of C_HIT inside[i].",
     .step = 0,
     .share = 0.125,
     .once = true},
    {.looks_like = "the steps alone",
     .hint = "What is inside is tested, with probability 1/4: C_HIT inside[i] / 4.",
     .step = 1,
     .share = 0},
    {.looks_like = "a step for all eight children, also the empty ones",
     .hint = "A child with nothing in it is not stored and costs nothing.",
     .step = 1,
     .share = 0.25,
     .all_eight = true},
    {.looks_like = "all that is inside, not a quarter of it",
     .hint = "A ray through the cell passes through a child with probability 1/4 only.",
     .step = 1,
     .share = 1},
    {.looks_like = "an eighth of what is inside, not a quarter",
     .hint =
         "A ray that passes through a cell passes through two of its eight children: 1/4 each.",
     .step = 1,
     .share = 0.125},
    {.looks_like = "a half of what is inside, not a quarter",
     .hint = "A ray through the cell passes through a child with probability 1/4.",
     .step = 1,
     .share = 0.5},
    {.looks_like = "divided also where it is as dear",
     .hint = "As dear: nothing is won. cost < C_HIT * count.",
     .step = 1,
     .share = 0.25,
     .equal = true},
    {.looks_like = "always divided: the cost is not asked",
     .hint = "The third reason: where dividing costs as much as testing all, or more.",
     .step = 0,
     .share = 0},
};

static bool worth_with_slip(int slip, int count, const int inside[8]) {
    double cost = worth_slips[slip].once ? C_STEP : 0;
    int sum = 0;
    for (int i = 0; i < 8; i++) {
        if (inside[i] || worth_slips[slip].all_eight) cost += worth_slips[slip].step;
        sum += inside[i];
        const double share = worth_slips[slip].share * inside[i];
        if (!worth_slips[slip].whole_sum)
            cost += worth_slips[slip].whole ? floor(share) : share;
    }
    if (worth_slips[slip].whole_sum) cost += sum / 4;
    return count > usual.leaf_size && (worth_slips[slip].equal ? cost <= count : cost < count);
}

// A division of `count` triangles, near where it pays.
static int some_division(rng *g, int inside[8]) {
    const int children = random_below(g, 9), most = 1 + random_below(g, 40);
    double cost = 0;
    for (int i = 0; i < 8; i++) {
        inside[i] = random_below(g, 8) < children ? random_below(g, most + 1) : 0;
        if (inside[i]) cost += C_STEP + C_HIT * inside[i] / 4.0;
    }
    const int count = (int)cost - 3 + random_below(g, 8);
    return count > usual.leaf_size ? count : usual.leaf_size + 1;
}

// The slip that explains all answers; or -1.
static int worth_slip(void) {
    for (int slip = 0; slip < COUNT(worth_slips); slip++) {
        rng g = check_rng(1426);
        bool all = true;
        for (int i = 0; i < 2000; i++) {
            int inside[8];
            const int count = some_division(&g, inside);
            all &=
                worth_dividing(usual, 3, count, inside) == worth_with_slip(slip, count, inside);
        }
        if (all) return slip;
    }
    return -1;
}

static void check_worth(int count, const int inside[8], bool worth, const char *why) {
    const bool got = worth_dividing(usual, 3, count, inside);
    if (got == worth) return;
    const int slip = worth_slip();
    double cost = 0;
    for (int i = 0; i < 8; i++)
        if (inside[i]) cost += C_STEP + C_HIT * inside[i] / 4.0;
    given("%d triangles, leaf_size = %d; in the children %d %d %d %d %d %d %d %d%s%s\n"
          "dividing costs %.9g, testing all %d",
          count, usual.leaf_size, inside[0], inside[1], inside[2], inside[3], inside[4],
          inside[5], inside[6], inside[7], *why ? ": " : "", why, cost, count);
    if (slip >= 0) suspect_slip(worth_slips[slip].looks_like);
    if (slip >= 0) hint_instead(worth_slips[slip].hint);
    check_bool(__FILE__, __LINE__, "worth_dividing(how, 3, count, inside)", got, worth);
}

static void worth_random(void) {
    rng g = check_rng(1427);
    for (int i = 0; i < 5000; i++) {
        int inside[8];
        const int count = some_division(&g, inside);
        int quarters = 0;
        for (int k = 0; k < 8; k++)
            if (inside[k]) quarters += 4 * C_STEP + C_HIT * inside[k];
        check_worth(count, inside, quarters < 4 * C_HIT * count, "");
    }
}

static void worth_cost(void) {
    static const struct {
        int count, inside[8];
        bool worth;
        const char *why;
    } rows[] = {
        {20, {20, 20, 20, 20, 20, 20, 20, 20}, false, "all in all children: 8 + 40 against 20"},
        {20, {20, 20, 20, 20}, false, "all in four children: 4 + 20 against 20"},
        {20, {0, 20, 0, 0, 20}, true, "all in two children: 2 + 10 against 20"},
        {20, {0, 0, 20}, true, "all in one child: 1 + 5 against 20"},
        {10, {5, 5, 5, 5, 5, 5, 5, 5}, false, "8 + 10 against 10"},
        {20, {6, 6, 6, 6, 6, 6, 6, 6}, false, "8 + 12 against 20: as dear, nothing is won"},
        {20, {6, 6, 6, 6, 6, 6, 6, 5}, true, "8 + 11.75 against 20"},
        {21, {6, 6, 6, 6, 6, 6, 6, 6}, true, "8 + 12 against 21"},
        {1000, {1000, 1000, 1000, 1000}, false, "a thousand, coincident, across four"},
        {1000, {250, 250, 250, 250, 0, 0, 0, 0}, true, "a thousand in four parts"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        check_worth(rows[i].count, rows[i].inside, rows[i].worth, rows[i].why);
    }
}

static void worth_coincident(void) {
    soup s = soup_new(3000);
    const vec3 a = {(real)0.1, (real)0.7, (real)0.3}, b = {(real)0.9, (real)0.2, (real)0.1},
               c = {(real)0.4, (real)0.3, (real)0.8};
    while (s.count < 3000) soup_add(&s, a, b, c);
    mesh m = soup_mesh(s);
    octree o = octree_build(&m, octree_defaults);
    const octree_figures f = octree_measure(&o);
    given("3000 times the same triangle: %d leaves, %d entries, depth %d", f.leaves, f.entries,
          f.depth);
    hint_instead(
        "All 3000 are in each child that one is in: the cost says no, and at the latest "
        "the depth.");
    check_at_most(__FILE__, __LINE__, "leaves of octree_build's tree", f.leaves, 8,
                  "divides once at most: a division parts none of them");
    octree_free(&o);
    mesh_free(&m);
}

// ---- what is given ---------------------------------------------------------------------------

static void trees_keep_promises(void) {
    static const octree_options ways[] = {{4, OCTREE_DEPTH, 16, false},
                                          {1, OCTREE_DEPTH, 64, false},
                                          {1, 5, 16, true},
                                          {8, 3, 16, false},
                                          {0, OCTREE_DEPTH, 2, false},
                                          {100000, 9, 16, false}};
    rng g = check_rng(1420);
    for (int k = 0; k < COUNT(scene_rows); k++) {
        mesh m = scene_rows[k].make(&g);
        for (int w = 0; w < COUNT(ways); w++) {
            octree a = octree_build(&m, ways[w]), b = octree_build(&m, ways[w]);
            const octree_figures f = octree_measure(&a);
            given("%s; leaf_size %d, depth %d, memory %d%s", scene_rows[k].name,
                  ways[w].leaf_size, ways[w].depth, ways[w].memory,
                  ways[w].dense ? ", dense" : "");
            const char *flaw = octree_flaw(&a);
            CHECK(flaw == NULL, flaw ? flaw : "no promise is broken");
            CHECK_AT_MOST(f.depth, ways[w].depth, "how.depth");
            CHECK_AT_MOST(f.entries, ways[w].memory * m.count + 64, "how.memory a triangle");
            CHECK_AT_MOST(a.node_count, ways[w].memory * m.count + 64, "how.memory a triangle");
            CHECK_INT(f.leaves + f.inner, a.node_count);
            CHECK(a.node_count == b.node_count && a.entry_count == b.entry_count &&
                      (!a.node_count ||
                       !memcmp(a.nodes, b.nodes, sizeof *a.nodes * (size_t)a.node_count)) &&
                      (!a.entry_count ||
                       !memcmp(a.lists, b.lists, sizeof *a.lists * (size_t)a.entry_count)),
                  "built twice it is the same, bit for bit");
            octree_free(&a);
            octree_free(&b);
        }
        mesh_free(&m);
    }
}

static void flaws_are_found(void) {
    rng g = check_rng(1421);
    mesh m = scene_soup(&g);
    for (int kind = 0; kind < 5; kind++) {
        octree o = built(&m);
        CHECK(octree_flaw(&o) == NULL, "a sound tree");
        int leaf = 0;
        while (!is_leaf(&o.nodes[leaf]) || o.nodes[leaf].count < 2) leaf++;
        octree_node *n = &o.nodes[leaf];
        if (kind == 0) n->count--; // its last triangle is missing
        if (kind == 1) o.lists[n->first + 1] = o.lists[n->first];
        if (kind == 2) n->first = o.entry_count;
        if (kind == 3) o.nodes[0].first = 0;
        if (kind == 4) o.how.depth = 1;
        static const char *const what[] = {"a triangle lost", "one twice", "a list outside",
                                           "a child that is its parent", "a leaf too deep"};
        given("%s", what[kind]);
        // A lost triangle is missed where a corner lies; not every one has a corner there.
        const char *flaw = octree_flaw(&o);
        if (kind > 0) CHECK(flaw != NULL, "the flaw is found");
        octree_free(&o);
    }
    mesh_free(&m);
}

static void leaf_around(void) {
    rng g = check_rng(1422);
    mesh m = shape_knot(3000);
    octree o = built(&m);
    for (int i = 0; i < 5000; i++) {
        const vec3 p = i & 1 ? point_of(&m, &g) : scale((real)1.2, in_cube(&g));
        aabb cell;
        int depth;
        const octree_node *leaf = octree_at(&o, p, &cell, &depth);
        const aabb cube = o.cube;
        const bool in_cube_of = surely_overlaps((triangle){p, p, p}, cube, 0);
        given("the point " VEC " of a knot", ARG(p));
        CHECK((depth >= 0) == in_cube_of, "depth -1 outside of the cube only");
        if (depth < 0) continue;
        CHECK(surely_overlaps((triangle){p, p, p}, cell, 0), "the point is in its cell");
        const real side = (cube.max.x - cube.min.x) * ldexp((real)1, -depth);
        CHECK_REAL(cell.max.x - cell.min.x, side, absolute_of(4 * REAL_EPSILON, "halving"));
        CHECK(!leaf || is_leaf(leaf), "a leaf");
        CHECK(leaf || (i & 1) == 0, "where a triangle is there is a leaf");
    }
    octree_free(&o);
    mesh_free(&m);
}

static void dense_like_sparse(void) {
    rng g = check_rng(1423);
    mesh m = scene_soup(&g);
    octree_options how = octree_defaults;
    octree sparse = octree_build(&m, how);
    how.dense = true;
    octree dense = octree_build(&m, how);
    CHECK(dense.node_count > sparse.node_count, "empty children are stored");
    CHECK_INT(dense.entry_count, sparse.entry_count);
    CHECK_INT(dense.node_count, 8 * octree_measure(&dense).inner + 1);
    searches_begin(&dense);
    for (int i = 0; i < 1000; i++)
        check_nearest(random_probe(&m, finite_box(&m), &g), "a soup, dense");
    searches_end();
    octree_free(&sparse);
    octree_free(&dense);
    mesh_free(&m);
}

static void as_finder(void) {
    rng g = check_rng(1424);
    mesh m = scene_cave(&g), with = m;
    octree o = built(&m);
    const finder f = octree_finder(&o);
    with.finder = &f;
    for (int i = 0; i < 500; i++) {
        const probe p = random_probe(&m, finite_box(&m), &g);
        int a = -1, b = -1;
        given("a cave; " PROBE, ARG_PROBE(p));
        CHECK_REAL(mesh_hit(&with, p.r, p.t_min, p.t_max, &a).t,
                   mesh_hit(&m, p.r, p.t_min, p.t_max, &b).t, exactly());
        CHECK_INT(a, b);
        CHECK_BOOL(mesh_any(&with, p.r, p.t_min, p.t_max), b >= 0);
    }
    octree_free(&o);
    mesh_free(&m);
}

// ---- all of them --------------------------------------------------------------------------

static const searcher *const trees[] = {&by_bvh_median, &by_bvh_midpoint, &by_bvh_sah,
                                        &by_kd_tree, &by_octree};

static void check_agreement(const searcher *s, const void *tree, probe p, const char *where,
                            triangle_point want, int want_index) {
    int index = -7;
    effort spent = {0, 0};
    const triangle_point got = s->nearest(tree, p.r, p.t_min, p.t_max, &index, &spent);
    const bool any = s->any(tree, p.r, p.t_min, p.t_max, NULL);
    if (got.t == want.t && index == want_index && any == (want.t != NO_HIT)) return;
    given("%s in %s; " PROBE, s->name, where, ARG_PROBE(p));
    CHECK_REAL(got.t, want.t, exactly());
    CHECK_INT(index, want_index);
    CHECK_BOOL(any, want.t != NO_HIT);
}

static void agreement(const mesh *m, const char *where, int rays, rng *g) {
    void *built_trees[COUNT(trees)];
    const aabb box = finite_box(m);
    for (int k = 0; k < COUNT(trees); k++) {
        built_trees[k] = trees[k]->build(m);
        const char *flaw = trees[k]->flaw(built_trees[k]);
        given("%s of %s", trees[k]->name, where);
        CHECK(flaw == NULL, flaw ? flaw : "no promise is broken");
    }
    for (int i = 0; i < rays; i++) {
        const probe p = random_probe(m, box, g);
        int index = -7;
        const triangle_point want = mesh_hit(m, p.r, p.t_min, p.t_max, &index);
        for (int k = 0; k < COUNT(trees); k++)
            check_agreement(trees[k], built_trees[k], p, where, want, index);
    }
    for (int k = 0; k < COUNT(trees); k++) trees[k]->free(built_trees[k]);
}

// AGREE=n in the environment: n rays in each where, and over all shapes.
static int rays_wanted(int usual_number) {
    const char *text = getenv("AGREE");
    return text ? atoi(text) : usual_number;
}

static void agree_adversarial(void) {
    rng g = check_rng(1430);
    for (int k = 0; k < COUNT(scene_rows); k++) {
        mesh m = scene_rows[k].make(&g);
        const int rays = scene_rows[k].built_only ? 0 : rays_wanted(1000);
        agreement(&m, scene_rows[k].name, rays, &g);
        mesh_free(&m);
    }
}

static void agree_shapes(void) {
    rng g = check_rng(1431);
    for (const shape *s = shapes; s->name; s++) {
        mesh m = s->make(1000);
        m.around.r = 0;
        agreement(&m, s->name, rays_wanted(500), &g);
        mesh_free(&m);
    }
}

int main(void) {
    static const char *const child = "One bit for each axis: x is bit 0. On the plane: the "
                                     "upper half.";
    static const char *const count = "How many bits are set in the mask below bit i?";
    static const char *const order = "Which child has nothing before it, and how does one with "
                                     "d.x < 0 differ from one with d.x > 0?";
    static const char *const overlap = "Closed: touching counts. Two convex bodies are apart "
                                       "when an axis parts them; rounding "
                                       "must never make it so.";
    static const char *const worth =
        "Three reasons to stop; which of them ends the division of "
        "a heap of equal triangles?";
    static const char *const walk = "Is the right cell asked, and when is a hit final?";
    static const char *const given_code = "Does a test of an exercise fail, too? Mend that "
                                          "first. Else: given code, did it change?";
    static const test tests[] = {
        {"child_of: 2000 generic points", child_around, child},
        {"child_of: on the dividing planes", child_on_plane, child},
        {"child_index: all masks", index_of_all, count},
        {"order_children: all signs", order_generic, order},
        {"order_children: components 0 and -0", order_zeros, order},
        {"order_children: components of very different size", order_uneven, order},
        {"cell_overlaps: far apart", overlaps_apart, overlap},
        {"cell_overlaps: against clipping in higher precision", overlaps_generic, overlap},
        {"cell_overlaps: flat in a face", overlaps_in_face, overlap},
        {"cell_overlaps: touching in one point", overlaps_touching, overlap},
        {"cell_overlaps: apart, and told apart", overlaps_told_apart, overlap},
        {"worth_dividing: the limits", worth_limits, worth},
        {"worth_dividing: the cost", worth_cost,
         "A step for each child with something in it, a quarter of what is inside; against "
         "testing all."},
        {"worth_dividing: 5000 random divisions", worth_random,
         "A step for each child with something in it, a quarter of what is inside; against "
         "testing all."},
        {"worth_dividing: coincident triangles", worth_coincident, worth},
        {"octree_nearest: an empty tree", nearest_empty, walk},
        {"octree_nearest: one and two triangles", nearest_few, walk},
        {"octree_nearest: a soup", nearest_soup, walk},
        {"octree_nearest: spent may be NULL", nearest_uncounted, walk},
        {"octree_nearest: a component of d is -0", nearest_minus_zero, walk},
        {"octree_nearest: from inside", nearest_inside, walk},
        {"octree_nearest: ties", nearest_ties, walk},
        {"octree_nearest: no more cells than needed", nearest_steps, walk},
        {"octree_nearest: 20 levels", nearest_deep, walk},
        {"octree_nearest: 20 levels, and all cells wait", nearest_full_stack, walk},
        {"octree_nearest: scenes that make trees stumble", nearest_adversarial, walk},
        {"octree_nearest: no ray leaves a closed mesh", nearest_closed, walk},
        {"octree: promises kept, and the same every time", trees_keep_promises, given_code},
        {"octree: flaws are found", flaws_are_found, given_code},
        {"octree_at: the leaf around a point", leaf_around, given_code},
        {"octree: dense as sparse", dense_like_sparse, given_code},
        {"octree_finder: a mesh searched by it", as_finder, given_code},
        {"searchers: agree on scenes that make trees stumble", agree_adversarial, given_code},
        {"searchers: agree on all shapes", agree_shapes, given_code},
    };
    return run_tests("14-octree", tests, COUNT(tests));
}
