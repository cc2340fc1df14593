// 14-octree-overlap.h: the part of 14-octree.c about cell_overlaps. Whether a pair overlaps is
// worked out by clipping, whether it is apart by the 13 axes, both in higher precision.
#ifndef TESTS_14_OCTREE_OVERLAP_H
#define TESTS_14_OCTREE_OVERLAP_H

#include <stdio.h>
#include <string.h>

#include "chapters/14-octree/octree.h"
#include "tests/14-octree-scenes.h"
#include "tests/check.h"

typedef struct {
    triangle T;
    aabb cell;
} pair14;

#define PAIR "cell " VEC " to " VEC "\ntriangle " VEC ", " VEC ", " VEC
#define ARG_PAIR(k) \
    ARG((k).cell.min), ARG((k).cell.max), ARG((k).T.p1), ARG((k).T.p2), ARG((k).T.p3)

// ---- by clipping ---------------------------------------------------------------------------

typedef struct {
    exact3 p[9];
    int count;
} polygon;

static exact component(exact3 p, int axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

// What of the polygon lies at or beyond `side` in the direction `sign` of the axis.
static polygon cut_off(polygon a, int axis, int sign, exact side) {
    polygon b = {.count = 0};
    for (int i = 0; i < a.count; i++) {
        const exact3 p = a.p[i], q = a.p[(i + 1) % a.count];
        const exact s = sign * (component(p, axis) - side),
                    t = sign * (component(q, axis) - side);
        if (s >= 0) b.p[b.count++] = p;
        if ((s < 0 && t > 0) || (s > 0 && t < 0)) {
            const exact3 e = {q.x - p.x, q.y - p.y, q.z - p.z};
            b.p[b.count++] = exact_along(p, s / (s - t), e);
        }
    }
    return b;
}

// Is a part of T within the cell made smaller by `margin` on each side?
static bool surely_overlaps(triangle T, aabb cell, exact margin) {
    polygon a = {{exact_of(T.p1), exact_of(T.p2), exact_of(T.p3)}, 3};
    for (int axis = 0; axis < 3 && a.count; axis++) {
        a = cut_off(a, axis, 1, (exact)along(cell.min, axis) + margin);
        a = cut_off(a, axis, -1, (exact)along(cell.max, axis) - margin);
    }
    return a.count > 0;
}

static aabb cell_at(vec3 min, real side) {
    return (aabb){min, add(min, (vec3){side, side, side})};
}

// ---- by axes -------------------------------------------------------------------------------

// 0 to 2: the cell's own; 3: the normal; 4 + 3 edge + axis: their product.
enum { AXES14 = 13, OWN_AXES = 7, NORMAL_AXIS = 8, EDGE_AXES = 0x1ff0, ALL_AXES = 0x1fff };

static exact3 axis14(triangle T, int k) {
    const exact3 e[3] = {exact_sub(T.p2, T.p1), exact_sub(T.p3, T.p2), exact_sub(T.p1, T.p3)};
    const exact3 own[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (k < 3) return own[k];
    return k == 3 ? exact_cross(e[0], e[1]) : exact_cross(own[(k - 4) % 3], e[(k - 4) / 3]);
}

static const char *axis14_name(int k) {
    static const char *const own[3] = {"x", "y", "z"};
    static const char *const edge[3] = {"p2 - p1", "p3 - p2", "p1 - p3"};
    static char name[40];
    if (k < 3) return own[k];
    if (k == 3) return "the normal";
    snprintf(name, sizeof name, "%s × (%s)", own[(k - 4) % 3], edge[(k - 4) / 3]);
    return name;
}

// Along an axis, with the cell's middle as origin.
typedef struct {
    exact3 a;
    exact reach, low, high; // the cell is from -reach to reach
} shadow14;

static exact least(exact a, exact b) {
    return a < b ? a : b;
}
static exact size_of(exact a) {
    return a < 0 ? -a : a;
}

static shadow14 shadow_along(pair14 k, exact3 a) {
    const exact3 low = exact_of(k.cell.min), side = exact_sub(k.cell.max, k.cell.min);
    const exact3 c = exact_along(low, (exact)0.5, side);
    const exact p = exact_dot(a, exact_along(exact_of(k.T.p1), -1, c)),
                q = exact_dot(a, exact_along(exact_of(k.T.p2), -1, c)),
                s = exact_dot(a, exact_along(exact_of(k.T.p3), -1, c));
    const exact reach =
        (size_of(a.x) * side.x + size_of(a.y) * side.y + size_of(a.z) * side.z) / 2;
    return (shadow14){a, reach, least(p, least(q, s)), -least(-p, least(-q, -s))};
}

// The gap along an axis of any length; negative where the intervals meet.
static exact gap_of(shadow14 s) {
    const exact length = exact_sqrt(exact_dot(s.a, s.a));
    const exact above = s.low - s.reach, below = -s.reach - s.high;
    return length > 0 ? -least(-above, -below) / length : -1;
}

// The axes along which the gap is more than `room`.
static unsigned parting_axes(pair14 k, exact room) {
    unsigned axes = 0;
    for (int i = 0; i < AXES14; i++)
        if (gap_of(shadow_along(k, axis14(k.T, i))) > room) axes |= 1u << i;
    return axes;
}

// ---- answers with a slip -------------------------------------------------------------------

// Of the corners along an axis, seen from the cell's middle.
static const struct {
    const char *looks_like, *hint;
    enum { ALL_BEYOND, ANY_BEYOND, ALL_OUTSIDE } apart;
    enum { REACH, SIGNED_REACH, SIZE_OF_SUM, HALF_REACH } reach;
    bool from_zero; // the corners as they are
} overlap_slips[] = {
    {"one corner beyond the cell's reach is taken for apart",
     "An axis parts them when all three corners lie beyond the same end: p > r && q > r && "
     "s > r, or all three < -r.",
     ANY_BEYOND, REACH, false},
    {"three corners beyond the cell's reach, but not all at the same end, are taken for apart",
     "All three > r, or all three < -r. Where |a·p| > r for all three an edge may still pass "
     "from one side to the other, through the cell.",
     ALL_OUTSIDE, REACH, false},
    {"r without |a|: a component of the axis may be negative",
     "The reach is r = |a.x| h.x + |a.y| h.y + |a.z| h.z, with fabs of each component.",
     ALL_BEYOND, SIGNED_REACH, false},
    {"r = |a.x h.x + a.y h.y + a.z h.z|: the size of the sum, not the sum of sizes",
     "The reach is r = |a.x| h.x + |a.y| h.y + |a.z| h.z, with fabs of each component.",
     ALL_BEYOND, SIZE_OF_SUM, false},
    {"r is half as long as the cell reaches",
     "h is half a side: from the middle the cell reaches h to both sides.", ALL_BEYOND,
     HALF_REACH, false},
    {"the corners as they are, not seen from the cell's middle",
     "The cell reaches from -r to r when its middle is the origin: a·(corner - middle).",
     ALL_BEYOND, REACH, true},
    {"one corner beyond is taken for apart, and r without |a|",
     "All three corners > r, or all three < -r; and r = |a.x| h.x + |a.y| h.y + |a.z| h.z.",
     ANY_BEYOND, SIGNED_REACH, false},
};

static bool slip_parts(int slip, const pair14 *k, exact3 a) {
    const wide3 x = {(double)a.x, (double)a.y, (double)a.z};
    const wide3 low = widen(k->cell.min), h = wide_sub(k->cell.max, k->cell.min);
    const double half = overlap_slips[slip].from_zero ? 0 : 0.5;
    wide3 c = wide_along(low, half, h);
    if (overlap_slips[slip].from_zero) c = (wide3){0, 0, 0};
    const double p = wide_dot(x, wide_along(widen(k->T.p1), -1, c)),
                 q = wide_dot(x, wide_along(widen(k->T.p2), -1, c)),
                 s = wide_dot(x, wide_along(widen(k->T.p3), -1, c));
    double r = (fabs(x.x) * h.x + fabs(x.y) * h.y + fabs(x.z) * h.z) / 2;
    if (overlap_slips[slip].reach == SIGNED_REACH) r = wide_dot(x, h) / 2;
    if (overlap_slips[slip].reach == SIZE_OF_SUM) r = fabs(wide_dot(x, h) / 2);
    if (overlap_slips[slip].reach == HALF_REACH) r /= 2;
    switch (overlap_slips[slip].apart) {
    case ANY_BEYOND:
        return p > r || q > r || s > r || p < -r || q < -r || s < -r;
    case ALL_OUTSIDE:
        return fabs(p) > r && fabs(q) > r && fabs(s) > r;
    default:
        return (p > r && q > r && s > r) || (p < -r && q < -r && s < -r);
    }
}

// A pair of which about every other overlaps.
static pair14 some_pair(double size, rng *g) {
    const real side = (real)(size * between(g, 0.1, 2));
    const aabb cell = cell_at(scale((real)size, in_cube(g)), side);
    const vec3 a = scale((real)(2 * size), in_cube(g)), b = scale((real)(2 * size), in_cube(g)),
               c = scale((real)(2 * size), in_cube(g));
    return (pair14){{a, b, c}, cell};
}

// A pair of bodies of different size: small triangles in a cell tell most slips apart.
static pair14 uneven_pair(rng *g) {
    pair14 k = some_pair(1, g);
    const vec3 c = aabb_centre(k.cell), at = scale((real)0.5, in_cube(g));
    const real size = (real)pow(10, between(g, -2, 0));
    vec3 *const p[3] = {&k.T.p1, &k.T.p2, &k.T.p3};
    for (int i = 0; i < 3; i++) *p[i] = add(add(c, at), scale(size, sub(*p[i], c)));
    return k;
}

// The slip that explains all answers and loses pairs, with these axes; those of the cell may be judged rightly, as
// boxes. Or -1.
static int overlap_slip(void) {
    static const unsigned sets[] = {
        ALL_AXES,    NORMAL_AXIS | EDGE_AXES, EDGE_AXES, EDGE_AXES | OWN_AXES,
        NORMAL_AXIS, NORMAL_AXIS | OWN_AXES,  OWN_AXES};
    for (int slip = 0; slip < COUNT(overlap_slips); slip++)
        for (int n = 0; n < 2 * COUNT(sets); n++) {
            rng g = check_rng(1427);
            bool all = true, loses = false;
            for (int i = 0; i < 1000 && all; i++) {
                const pair14 k = uneven_pair(&g);
                bool apart = n % 2 && parting_axes(k, 0) & OWN_AXES;
                for (int x = 0; x < AXES14 && !apart; x++)
                    if (sets[n / 2] >> x & 1) apart = slip_parts(slip, &k, axis14(k.T, x));
                all = cell_overlaps(k.T, k.cell) == !apart;
                loses |= apart && !parting_axes(k, 0);
            }
            if (all && loses) return slip;
        }
    return -1;
}

// Only where a corner is in the cell, or never.
static bool only_with_corner(bool never) {
    rng g = check_rng(1428);
    for (int i = 0; i < 1000; i++) {
        const pair14 k = uneven_pair(&g);
        bool corner = false;
        const vec3 p[3] = {k.T.p1, k.T.p2, k.T.p3};
        for (int c = 0; c < 3; c++)
            corner |= surely_overlaps((triangle){p[c], p[c], p[c]}, k.cell, 0);
        if (cell_overlaps(k.T, k.cell) != (corner && !never)) return false;
    }
    return true;
}

// ---- the tests -----------------------------------------------------------------------------

// Says what a lost pair looks like; `hint` where that is not known.
static void about_lost(const char *hint) {
    hint_instead(hint);
    const int slip = overlap_slip();
    if (slip >= 0) {
        suspect_slip(overlap_slips[slip].looks_like);
        hint_instead(overlap_slips[slip].hint);
    } else if (only_with_corner(true)) {
        suspect_slip("always false");
    } else if (only_with_corner(false)) {
        suspect_slip("true only where a corner of the triangle lies in the cell");
        hint_instead("Corners outside do not mean apart: an edge may pass through the cell, or "
                     "the cell through the middle of the triangle.");
    }
}

static bool has_corner_inside(pair14 k) {
    return surely_overlaps((triangle){k.T.p1, k.T.p1, k.T.p1}, k.cell, 0) ||
           surely_overlaps((triangle){k.T.p2, k.T.p2, k.T.p2}, k.cell, 0) ||
           surely_overlaps((triangle){k.T.p3, k.T.p3, k.T.p3}, k.cell, 0);
}

static pair14 sized_pair(int i, double *size, rng *g) {
    const double exponent = between(g, -6, 9);
    *size = i < 2000 ? 1 : pow(10, exponent);
    return some_pair(*size, g);
}

static void overlaps_generic(void) {
    rng g = check_rng(1406);
    int with_corner = 0, without = 0;
    for (int i = 0; i < 20000; i++) {
        double size;
        const pair14 k = sized_pair(i, &size, &g);
        if (!surely_overlaps(k.T, k.cell, 1e-12 * size)) continue;
        const bool corner = has_corner_inside(k);
        with_corner += corner, without += !corner;
        given(PAIR "\n%s; by clipping in higher precision they overlap", ARG_PAIR(k),
              corner ? "a corner lies in the cell" : "no corner lies in the cell");
        const bool got = cell_overlaps(k.T, k.cell);
        if (!got)
            about_lost("No plane parts them, so none of the axes may: along which one did the "
                       "triangle come to lie beyond the cell? Print a, r and the three a·p.");
        check_bool(__FILE__, __LINE__, "cell_overlaps(T, cell)", got, true);
    }
    CHECK(with_corner > 100 && without > 100, "the test has pairs of both kinds");
}

// Do pairs that overlap by far go well? What is lost elsewhere is then about touching.
static bool generic_goes_well(void) {
    rng g = check_rng(1406);
    for (int i = 0; i < 4000; i++) {
        double size;
        const pair14 k = sized_pair(i, &size, &g);
        if (surely_overlaps(k.T, k.cell, 1e-12 * size) && !cell_overlaps(k.T, k.cell))
            return false;
    }
    return true;
}

static void overlaps_apart(void) {
    rng g = check_rng(1407);
    for (int i = 0; i < 3000; i++) {
        const aabb cell = cell_at(in_cube(&g), (real)between(&g, 0.1, 1));
        const int axis = random_below(&g, 3);
        vec3 away = {0, 0, 0};
        *(axis == 0 ? &away.x : axis == 1 ? &away.y : &away.z) = random_below(&g, 2) ? 4 : -4;
        const vec3 a = in_cube(&g), b = in_cube(&g), c = in_cube(&g);
        const pair14 k = {{add(a, away), add(b, away), add(c, away)}, cell};
        given(PAIR "\ntheir boxes are far apart, along %c", ARG_PAIR(k), "xyz"[axis]);
        hint_instead(
            "Apart along one axis is apart: compare the boxes along x, y and z first.");
        CHECK_BOOL(cell_overlaps(k.T, k.cell), false);
    }
}

// A number with so few digits that sums of them are exact.
static real coarse(real unit, rng *g) {
    return (real)(random_below(g, 2 * (int)(1 / unit) - 1) + 1) * unit - 1;
}
static vec3 coarse_point(real unit, rng *g) {
    const real x = coarse(unit, g), y = coarse(unit, g), z = coarse(unit, g);
    return (vec3){x, y, z};
}

#define CLOSED                                                                               \
    "Closed: what only touches is not apart. Apart along an axis needs < and >, not <= and " \
    ">=; and a box or a reach without thickness still has points."
#define NOT_ABOUT_TOUCHING                                                                     \
    "This is not about touching: pairs that overlap by far are lost, too. The test \"against " \
    "clipping\" says more."

// Flat in a face of the cell, from either side of it.
static void overlaps_in_face(void) {
    rng g = check_rng(1408);
    const real unit = (real)1 / 4096;
    for (int i = 0; i < 2000; i++) {
        const real side = (real)(1 + random_below(&g, 4000)) * unit;
        const aabb cell = cell_at(coarse_point(unit, &g), side);
        const int axis = i % 3;
        const vec3 inside = aabb_centre(cell);
        triangle T = {inside, add(inside, coarse_point(unit, &g)),
                      add(inside, coarse_point(unit, &g))};
        const real face = along(i & 1 ? cell.min : cell.max, axis);
        vec3 *const p[3] = {&T.p1, &T.p2, &T.p3};
        for (int k = 0; k < 3; k++)
            *(axis == 0 ? &p[k]->x : axis == 1 ? &p[k]->y : &p[k]->z) = face;
        const pair14 k = {T, cell};
        given(PAIR "\nflat in the face %c = %.9g of the cell, and the face belongs to it: else "
                   "neither neighbour would list it",
              ARG_PAIR(k), "xyz"[axis], (double)face);
        const bool got = cell_overlaps(T, cell);
        if (!got) about_lost(generic_goes_well() ? CLOSED : NOT_ABOUT_TOUCHING);
        check_bool(__FILE__, __LINE__, "cell_overlaps(T, cell)", got, true);
    }
}

// ---- touching ------------------------------------------------------------------------------

// How many digits the coordinates have decides what is exact: in float with FEW, in double with
// SOME; with ALL that a real has, in none.
typedef enum { FEW, SOME, ALL } digits14;

// A part of 1, either way; added to 1.5 or taken off it gives no rounding.
static real digits_part(digits14 digits, double size, rng *g) {
    if (digits != ALL) return coarse(digits == FEW ? (real)1 / 16 : (real)1 / 4096, g);
    return ((real)1.5 + (real)(size * between(g, -1, 1))) - (real)1.5;
}
static vec3 digits_point(digits14 digits, double size, rng *g) {
    const real x = digits_part(digits, size, g), y = digits_part(digits, size, g),
               z = digits_part(digits, size, g);
    return (vec3){x, y, z};
}

static vec3 mirrored(vec3 p, int axes) {
    return (vec3){axes & 1 ? -p.x : p.x, axes & 2 ? -p.y : p.y, axes & 4 ? -p.z : p.z};
}

// The edges to the others from the cell's corner max, which the triangle touches from outside, and
// nothing else of the cell: at a corner, along an edge, or within.
static triangle touching_at(vec3 at, int kind, digits14 digits, double size, rng *g) {
    for (;;) {
        const vec3 u = digits_point(digits, size, g), v = digits_point(digits, size, g);
        const vec3 a = absolute(u), b = absolute(v), n = cross(u, v);
        const vec3 s = {a.x, -a.y, u.z};
        if (kind == 0) return (triangle){at, add(at, b), add(at, a)};
        if (kind == 1) return (triangle){add(at, s), sub(at, s), add(at, b)};
        if (n.x > 0 && n.y > 0 && n.z > 0)
            return (triangle){add(at, u), add(at, v), sub(at, add(u, v))};
    }
}

static pair14 touching_pair(digits14 digits, int i, rng *g) {
    const double size = digits == ALL ? ldexp(0.1, -random_below(g, 12)) : 1;
    const vec3 middle = {(real)1.5, (real)1.5, (real)1.5}, far = {1000, -2000, 500},
               zero = {0, 0, 0};
    const vec3 at = add(digits == ALL                  ? middle
                        : i % 4 == 0 && digits == SOME ? far
                                                       : zero,
                        digits_point(digits, size, g));
    real side = digits_part(digits, size, g);
    if (side < 0) side = -side;
    if (side == 0) side = (real)0.0625;
    const triangle T = touching_at(at, i % 3, digits, size, g);
    const vec3 low = sub(at, (vec3){side, side, side});
    const int m = random_below(g, 8);
    const vec3 p = mirrored(at, m), q = mirrored(low, m);
    return (pair14){{mirrored(T.p1, m), mirrored(T.p2, m), mirrored(T.p3, m)},
                    {{lesser(p.x, q.x), lesser(p.y, q.y), lesser(p.z, q.z)},
                     {greater(p.x, q.x), greater(p.y, q.y), greater(p.z, q.z)}}};
}

// A corner of the cell lies exactly on the triangle, and all the rest is outside.
static void touching_with(digits14 digits, const char *hint) {
    static const char *const kinds[] = {"a corner of the triangle on a corner of the cell",
                                        "an edge of the triangle through a corner of the cell",
                                        "a corner of the cell in the middle of the triangle"};
    rng g = check_rng(1409);
    for (int i = 0; i < 6000; i++) {
        const pair14 k = touching_pair(digits, i, &g);
        given(PAIR "\nthey touch in one point, and that counts: %s", ARG_PAIR(k), kinds[i % 3]);
        const bool got = cell_overlaps(k.T, k.cell);
        if (!got) about_lost(generic_goes_well() ? hint : NOT_ABOUT_TOUCHING);
        check_bool(__FILE__, __LINE__, "cell_overlaps(T, cell)", got, true);
    }
}

static void overlaps_touching(void) {
    touching_with(FEW, CLOSED);
    touching_with(SOME, "Rounding: with fewer digits, where all is exact in float, such pairs "
                        "went well. Compute in double: widen, wide_dot, wide_cross.");
    touching_with(ALL, "Rounding: with fewer digits, where all is exact in double, such pairs "
                       "went well. Leave room: h larger by 8 DBL_EPSILON times the largest "
                       "coordinates (of the corners and the cell, not times h), as the text "
                       "does.");
}

// ---- apart ---------------------------------------------------------------------------------

// A thousandth of the largest size in these pairs: smaller gaps may be taken for touching.
static const exact LEAST_GAP = 0.008;

// A pair that the axis k parts, by little: mostly no other does.
static pair14 parted_pair(int k, rng *g) {
    for (;;) {
        pair14 p = some_pair(1, g);
        const exact3 a = axis14(p.T, k);
        const exact length = exact_sqrt(exact_dot(a, a));
        if (!(length > (exact)0.1)) continue;
        const shadow14 s = shadow_along(p, a);
        const double wanted = between(g, 0.01, 0.03);
        const double move = (double)((s.reach - s.low) / length) + wanted;
        const exact step = (exact)move / length;
        const vec3 away = {(real)(step * a.x), (real)(step * a.y), (real)(step * a.z)};
        p.T = (triangle){add(p.T.p1, away), add(p.T.p2, away), add(p.T.p3, away)};
        return p;
    }
}

static int bits14(unsigned mask) {
    int count = 0;
    for (; mask; mask &= mask - 1) count++;
    return count;
}

// What axes are missing, in words, and what to do.
static const char *missing_in_words(unsigned missing) {
    static char words[400];
    const unsigned ten = NORMAL_AXIS | EDGE_AXES;
    if (missing == ALL_AXES) {
        hint_instead("No axis parts anything. Is r too long? The cell reaches h, half a side, "
                     "from its middle, and the triangle lies where its corners are.");
        return "none of the 13 axes parts them";
    }
    if (missing == ten) {
        hint_instead(
            "Boxes are a start, three axes of 13. Still to come: the triangle's normal, "
            "and for each edge its products with x, y and z.");
        return "only the boxes are compared: the other ten axes part nothing";
    }
    if (missing == NORMAL_AXIS) {
        hint_instead("The normal is the product of two edges, (p2 - p1) × (p3 - p1), not of "
                     "corners.");
        return "the triangle's normal parts nothing: it is missing, or another direction";
    }
    if (missing == EDGE_AXES) {
        hint_instead("For each of the edges p2 - p1, p3 - p2, p1 - p3 three axes: (0, -e.z, "
                     "e.y), (e.z, 0, -e.x), (-e.y, e.x, 0).");
        return "the nine products of axis and edge part nothing: they are missing, or other "
               "directions";
    }
    for (int x = 0; x < 3; x++) {
        if (missing == 0x49u << (4 + x)) {
            hint_instead(
                "With e an edge: x × e = (0, -e.z, e.y), y × e = (e.z, 0, -e.x), z × e "
                "= (-e.y, e.x, 0). One of two signs is minus.");
            snprintf(
                words, sizeof words,
                "the products of %c and the edges part nothing: they are missing, or other "
                "directions",
                "xyz"[x]);
            return words;
        }
        if (missing == 7u << (4 + 3 * x)) {
            static const char *const edge[3] = {"p2 - p1", "p3 - p2", "p1 - p3"};
            hint_instead("Three edges: p2 - p1, p3 - p2, p1 - p3.");
            snprintf(words, sizeof words,
                     "the edge %s parts nothing: it is missing, or another", edge[x]);
            return words;
        }
    }
    hint_instead(
        "13 axes: x, y, z; the normal (p2 - p1) × (p3 - p1); and x × e, y × e, z × e "
        "for each edge e. Along each: a·(corner - middle) against r = |a.x| h.x + |a.y| "
        "h.y + |a.z| h.z.");
    snprintf(words, sizeof words, "of 13 axes these part nothing:");
    for (int k = 0; k < AXES14; k++)
        if (missing >> k & 1)
            snprintf(words + strlen(words), sizeof words - strlen(words), "%s %s",
                     words[strlen(words) - 1] == ':' ? "" : ",", axis14_name(k));
    return words;
}

// An axis is missing that parts a pair which is not told apart. The pairs are such that each axis
// is the only one for many.
static void overlaps_told_apart(void) {
    rng g = check_rng(1429);
    unsigned missing = 0, fewest = 0;
    int told = 0, all = 0, only[AXES14] = {0};
    pair14 lost = {0};
    for (int i = 0; i < 13000; i++) {
        const pair14 k = parted_pair(i % AXES14, &g);
        const unsigned axes = parting_axes(k, LEAST_GAP);
        if (!axes) continue;
        if (bits14(axes) == 1) only[i % AXES14]++;
        given(PAIR, ARG_PAIR(k));
        const bool got = cell_overlaps(k.T, k.cell);
        all++, told += !got;
        if (!got) continue;
        missing |= axes;
        if (!fewest || bits14(axes) < bits14(fewest)) fewest = axes, lost = k;
    }
    for (int k = 0; k < AXES14; k++) CHECK(only[k] > 20, "the test has pairs for each axis");
    if (!missing) return;
    int first = 0;
    while (!(fewest >> first & 1)) first++;
    const shadow14 s = shadow_along(lost, axis14(lost.T, first));
    given(PAIR
          "\nalong %s, (%.9g, %.9g, %.9g), the cell reaches from %.9g to %.9g, the "
          "triangle from %.9g to %.9g: apart\nof %d pairs that are apart %d are told apart",
          ARG_PAIR(lost), axis14_name(first), (double)s.a.x, (double)s.a.y, (double)s.a.z,
          (double)-s.reach, (double)s.reach, (double)s.low, (double)s.high, all, told);
    suspect_slip(missing_in_words(missing));
    check_bool(__FILE__, __LINE__, "cell_overlaps(T, cell)", true, false);
}

#endif
