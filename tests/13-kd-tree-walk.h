// 13-kd-tree-walk.h: the part of 13-kd-tree.c about the walk, and about whole trees.
#ifndef TESTS_13_KD_TREE_WALK_H
#define TESTS_13_KD_TREE_WALK_H

#include "chapters/13-kd-tree/kd_leaf.h"
#include "tests/13-kd-tree-parts.h"
#include "tests/check-trees.h"

#define NEAREST_T "kd_nearest(tree, r, t_min, t_max, &index, NULL).t"
#define ANY_CALL "kd_any(tree, r, t_min, t_max, NULL)"

// ---- what it may be, besides the walk ------------------------------------------------------

static const char *const children_first =
    "kd_children is wrong, too (make test-13 T=kd_children): that one first.";

static const char *slip_hint(void);

static bool lies_in_a_plane(const kd_tree *k, ray r) {
    const real O[] = {r.O.x, r.O.y, r.O.z}, d[] = {r.d.x, r.d.y, r.d.z};
    for (long i = 0; i < k->node_count; i++) {
        const uint32_t axis = kd_kind(k->nodes[i]);
        if (axis != KD_LEAF && d[axis] == 0 && O[axis] == k->nodes[i].split) return true;
    }
    return false;
}

// Is it the tree's fault, or kd_children's, or a slip that is known? NULL when none is to blame.
static const char *kd_blame(const kd_tree *k) {
    static char words[300];
    if (k->count && !k->list_count)
        return "No triangle is in any leaf: does kd_sides put them in no child? That one "
               "first.";
    const char *flaw = kd_flaw(k);
    snprintf(words, sizeof words,
             "The tree is not right: %s. Not the walk's fault: which of kd_sides, kd_cost and "
             "kd_clip fails above? That one first.",
             flaw ? flaw : "");
    return flaw ? words : children_are_right() ? slip_hint() : children_first;
}

static const char *kd_about(const tree_case *c, ray r, real t, real want, int got) {
    const kd_tree *k = c->tree;
    const char *blame = kd_blame(k);
    if (blame) return blame;
    if (want == NO_HIT || t < want) return NULL;
    if (t > want && want * wide_length(r.d) < 1e-10 * (wide_length(r.O) + 1e-4))
        return "The hit lies where the ray begins, but for rounding, and there spans are [0, "
               "0]. "
               "A span with t0 = t1 is not empty: t0 <= t1.";
    if (got < 0) return NULL;
    if (lies_in_a_plane(k, r))
        return "The ray lies in a plane of the tree, so it is in both children for all of its "
               "span: the one that waits may hold the nearer hit, or the same t and a smaller "
               "index. Neither that the hit lies inside its cell nor that the top of the stack "
               "begins behind it is enough: all that waits and begins before it is asked, "
               "whatever the top of the stack says.";
    return NULL;
}

static const tree_case kd_case = {
    .by = &by_kd_tree, .nearest = NEAREST_T, .any = ANY_CALL, .about = kd_about};

// ---- a tree made by hand ------------------------------------------------------------------

// Three walls across x, at x = 1, 3, 5, and one that leans from x = 0.5 above to 5.5 below. The
// plane x = 2 parts them: the leaning one is in both cells.
static const vec3 hand_points[] = {
    {1, 4, -4},   {1, 9, -4},    {1, 4, 9},     // 0: only y >= 4
    {3, -9, -9},  {3, 9, -9},    {3, 0, 9},     // 1: all of the middle
    {5, -9, -9},  {5, 9, -9},    {5, 0, 9},     // 2
    {0.5f, 4, 9}, {0.5f, 4, -9}, {5.5f, -4, 0}, // 3: x = 3 - 5 y / 8, cuts y = 0 at x = 3
};
static const int hand_corners[][3] = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};

// x = 2: below it triangles 0 and 3; above it, x = 4 parts 1 and 3 from 2 and 3.
static kd_tree hand_tree(const mesh *m) {
    static kd_node nodes[5];
    static uint32_t lists[] = {0, 3, 1, 3, 2, 3};
    nodes[0] = (kd_node){.split = 2, .packed = 0 | 2 << 2};
    nodes[1] = (kd_node){.first = 0, .packed = KD_LEAF | 2 << 2};
    nodes[2] = (kd_node){.split = 4, .packed = 0 | 4 << 2};
    nodes[3] = (kd_node){.first = 2, .packed = KD_LEAF | 2 << 2};
    nodes[4] = (kd_node){.first = 4, .packed = KD_LEAF | 2 << 2};
    return (kd_tree){.m = m,
                     .box = {{0.5f, -9, -9}, {5.5f, 9, 9}},
                     .nodes = nodes,
                     .lists = lists,
                     .node_count = 5,
                     .list_count = 6,
                     .count = 4,
                     .how = kd_defaults};
}

static const mesh hand_mesh = {.points = hand_points, .corners = hand_corners, .count = 4};

static void given_hand(ray r, real t_min, real t_max, const char *spent, const char *what) {
    given("triangles 0, 1, 2 at x = 1, 3, 5; 3 leans through all; planes at x = 2 and 4\n"
          "ray O = " VEC ", d = " VEC "; t_min = %.9g, t_max = %.9g; spent %s\n%s",
          ARG(r.O), ARG(r.d), (double)t_min, (double)t_max, spent, what);
}

// ---- walks gone wrong -----------------------------------------------------------------------

// What is known to go wrong in a walk.
typedef enum { EXCHANGED, FIRST_LEAF, OWN_FOUND, SLIPS } slip;

static const struct {
    const char *looks_like, *hint;
} slips[SLIPS] = {
    {"near and far went to each other's child",
     "o.near belongs to the child that comes first: that is the one above when o.first is 1, "
     "the one below when it is 0."},
    {"a hit that lies outside the cell in whose leaf it was found: a nearer one waits in the "
     "next cell",
     "A leaf's triangle may be hit behind the cell's end. What may still lie before that hit? "
     "All that waits and begins before it must still be asked."},
    {"the first of two leaves that hit at the same t",
     "Between leaves, too, the smaller index counts. One found for the whole walk sees to it: "
     "kd_leaf_nearest compares."},
};

// Below a node, with the slip. True: the walk is over.
static bool slip_below(const kd_tree *k, uint32_t node, span in, ray r, real t_min, slip s,
                       bvh_found *found) {
    const kd_node n = k->nodes[node];
    const uint32_t axis = kd_kind(n);
    if (axis == KD_LEAF) {
        bvh_found own = bvh_nothing_found(found->limit);
        kd_leaf_nearest(k, n, r, t_min, s == OWN_FOUND ? &own : found, NULL);
        if (own.best.t < found->best.t) *found = own;
        return s == FIRST_LEAF && found->best.t != NO_HIT;
    }
    const kd_ray q = kd_ray_of(r);
    const kd_order o = kd_children(n.split, q.O[axis], q.inverse[axis], in);
    const bool above_first = (o.first != 0) != (s == EXCHANGED);
    const uint32_t below = node + 1, above = kd_number(n);
    if (o.near.t0 <= o.near.t1 &&
        slip_below(k, above_first ? above : below, o.near, r, t_min, s, found))
        return true;
    return o.far.t0 <= o.far.t1 && o.far.t0 <= found->limit &&
           slip_below(k, above_first ? below : above, o.far, r, t_min, s, found);
}

static const ray hand_rays[] = {
    {{0, -1, 0}, {1, 0, 0}},    {{0, 1, 0}, {1, 0, 0}},     {{0, -2, 0}, {1, 0, 0}},
    {{7, 1, 0}, {-2, 0, 0}},    {{4.5f, 1, 0}, {-1, 0, 0}}, {{2.75f, 1, 0}, {-1, 0, 0}},
    {{0, 6, 0}, {1, 0, 0}},     {{2, 1, 0}, {1, 0, 0}},     {{2, 5, 1}, {-0.0f, -1, 0}},
    {{0, 0, 0}, {1, 0, 0}},     {{6, 0, 0}, {-1, 0, 0}},    {{0, 6, 0.5f}, {1, 0, 0.1f}},
    {{1.5f, 5, 0}, {-1, 0, 0}},
};

// The slip that gives the student's t and index for all rays; SLIPS: none that is known.
static slip known_slip(void) {
    const kd_tree k = hand_tree(&hand_mesh);
    for (int s = 0; s < SLIPS; s++) {
        bool same = true;
        for (int i = 0; i < COUNT(hand_rays) && same; i++) {
            const kd_ray q = kd_ray_of(hand_rays[i]);
            bvh_found found = bvh_nothing_found(NO_HIT);
            span in;
            int index = -1;
            if (kd_enter(&k, &q, 0, NO_HIT, &in))
                slip_below(&k, 0, in, hand_rays[i], 0, (slip)s, &found);
            const real t = kd_nearest(&k, hand_rays[i], 0, NO_HIT, &index, NULL).t;
            same = t == found.best.t && index == found.index;
        }
        if (same) return (slip)s;
    }
    return SLIPS;
}

static const char *slip_hint(void) {
    const slip s = known_slip();
    return s < SLIPS ? slips[s].hint : NULL;
}

// A hit of the hand-made tree that is not as it should be.
static void about_hand(ray r, real t, real want, int got, bool near) {
    if (!children_are_right()) {
        hint_instead(children_first);
        return;
    }
    const slip s = known_slip();
    hint_instead(s < SLIPS ? slips[s].hint
                           : tree_hint(&hand_mesh, r, t, near ? t : want, got, -7));
    if (s < SLIPS && near)
        suspect_value(slips[s].looks_like, got);
    else if (s < SLIPS)
        suspect_value(slips[s].looks_like, (double)t);
    else if (t > want && t != NO_HIT)
        suspect_value("a hit further away: a nearer one waits in another cell", (double)t);
}

static void check_hand(ray r, real t_min, real t_max, real t, int index, const char *what) {
    const kd_tree k = hand_tree(&hand_mesh);
    int got = -7;
    given_hand(r, t_min, t_max, "= NULL", what);
    const triangle_point q = kd_nearest(&k, r, t_min, t_max, &got, NULL);
    const bool near = q.t == t || (t != NO_HIT && fabs(q.t - t) <= 4 * REAL_EPSILON * t);
    if (!near || got != index) about_hand(r, q.t, t, got, near);
    if (t != NO_HIT) suspect_value("a miss: a hit is lost", (double)NO_HIT);
    check_real(__FILE__, __LINE__, NEAREST_T, (double)q.t, (double)t,
               roundings(4, "the triangle's test rounds t once"));
    suspect_value("untouched, after a hit", -7);
    if (index >= 0 && got > index) {
        const bool tie = triangle_hit(mesh_triangle(&hand_mesh, got & 3), r, 0, NO_HIT).t == t;
        if (tie) suspect_value("of equally near triangles the smallest index counts", got);
    }
    check_int(__FILE__, __LINE__, "index", got, index);
}

static void nearest_by_hand(void) {
    const ray low = {{0, -1, 0}, {1, 0, 0}}, high = {{0, 1, 0}, {1, 0, 0}};
    check_hand(low, 0, NO_HIT, 3, 1,
               "in the first cell 3 is hit, at x = 3.625: behind its end");
    check_hand(high, 0, NO_HIT, 2.375f, 3, "in the second cell 3 is hit at x = 2.375");
    check_hand((ray){{0, -2, 0}, {1, 0, 0}}, 0, NO_HIT, 3, 1, "3 lies at x = 4.25");
    check_hand((ray){{7, 1, 0}, {-2, 0, 0}}, 0, NO_HIT, 1, 2, "from the other end");
    check_hand((ray){{4.5f, 1, 0}, {-1, 0, 0}}, 0, NO_HIT, 1.5f, 1, "from inside, backwards");
    check_hand((ray){{2.75f, 1, 0}, {-1, 0, 0}}, 0, NO_HIT, 0.375f, 3,
               "O lies above x = 2, and the hit too");
    check_hand((ray){{0, 6, 0}, {1, 0, 0}}, 0, NO_HIT, 1, 0,
               "the first wall, which only stands there");
    check_hand((ray){{2, 1, 0}, {1, 0, 0}}, 0, NO_HIT, 0.375f, 3, "O in the plane x = 2");
    check_hand((ray){{2, 5, 1}, {-0.0f, -1, 0}}, 0, NO_HIT, (real)3.4, 3,
               "in the plane x = 2: 3 lies at y = 1.6");
}

static void nearest_interval(void) {
    const ray r = {{0, 1, 0}, {1, 0, 0}};
    check_hand(r, 2.375f, NO_HIT, 3, 1, "t > t_min: the first hit is not");
    check_hand(r, 3, NO_HIT, 5, 2, "t > t_min: two hits are not");
    check_hand(r, 5, NO_HIT, NO_HIT, -7, "nothing behind t_min; index stays untouched");
    check_hand(r, 0, 2.375f, NO_HIT, -7, "t < t_max: nothing before; index stays untouched");
    check_hand(r, 0, 2.5f, 2.375f, 3, "one before t_max");
    check_hand((ray){{0, 40, 0}, {1, 0, 0}}, 0, NO_HIT, NO_HIT, -7, "beside the root's box");
}

// What was counted is not what should be: why?
static const char *about_effort(long got_steps, long got_tests, long steps, long tests) {
    if (!children_are_right()) return children_first;
    if (slip_hint()) return slip_hint();
    if (got_steps < 0 || got_tests < 0)
        return "What was in *spent stays, and more is added: +=, not =.";
    if (tests && got_tests == 2 * tests && got_steps == steps)
        return "kd_leaf_nearest counts the tests already, when it is handed spent.";
    if (tests && got_tests == 0)
        return "kd_leaf_nearest adds the tests when it is handed spent.";
    if (got_tests < tests)
        return "Fewer than needed: a child that the ray is in was not asked.";
    if (got_tests == tests && got_steps < steps)
        return "One step for the root's box, asked by kd_enter, and one for each plane, asked "
               "by "
               "kd_children.";
    if (steps == 1) return "kd_enter says whether the ray is in the root's box at all.";
    return "Asked without need. Does the near child come first, and the far one wait (o.first, "
           "o.near, o.far)? Is a child whose span is empty left alone? Is what waits and "
           "begins "
           "behind found.limit left out?";
}

// What a walk by hand spends, and a tree without nodes.
static void check_effort(ray r, long steps, long tests, const char *what) {
    const kd_tree k = hand_tree(&hand_mesh);
    int index = -7;
    effort spent = {100, 1000};
    given_hand(r, 0, NO_HIT, "= {100, 1000} before", what);
    kd_nearest(&k, r, 0, NO_HIT, &index, &spent);
    const long more_steps = spent.steps - 100, more_tests = spent.tests - 1000;
    hint_instead(about_effort(more_steps, more_tests, steps, tests));
    suspect_value("not added to what was there", (double)tests);
    if (more_steps == steps)
        suspect_value("added twice: kd_leaf_nearest counts the tests already",
                      1000 + 2 * (double)tests);
    if (tests) suspect_value("no test is counted", 1000);
    check_int(__FILE__, __LINE__, "spent.tests", spent.tests, 1000 + tests);
    given_hand(r, 0, NO_HIT, "= {100, 1000} before", what);
    hint_instead(about_effort(more_steps, more_tests, steps, tests));
    suspect_value("no step is counted", 100);
    suspect_value("not added to what was there", (double)steps);
    suspect_value("one step is missing: the root's box?", (double)(100 + steps - 1));
    check_int(__FILE__, __LINE__, "spent.steps", spent.steps, 100 + steps);
}

static void nearest_effort(void) {
    check_effort((ray){{0, 6, 0}, {1, 0, 0}}, 2, 2,
                 "0 is hit at x = 1: the cell behind x = 2 need not be asked");
    check_effort((ray){{0, -1, 0}, {1, 0, 0}}, 3, 4,
                 "1 is hit at x = 3: the cell behind x = 4 need not be asked");
    check_effort((ray){{7, -2, 0}, {-1, 0, 0}}, 3, 2,
                 "from the other end; 2 is hit at x = 5: nothing before x = 4 is asked");
    check_effort((ray){{4.5f, 8, -20}, {0, 0, 1}}, 3, 2,
                 "nothing is hit; the ray is only in the cell behind x = 4");
    check_effort((ray){{0, 40, 0}, {1, 0, 0}}, 1, 0, "beside the root's box");
}

static void nearest_nothing(void) {
    static const mesh none = {.count = 0};
    const kd_tree k = kd_build(&none, kd_defaults);
    int index = -7;
    given("a mesh without triangles: node_count = 0, nodes = NULL, and kd_enter says false");
    const triangle_point q =
        kd_nearest(&k, (ray){{0, 0, 0}, {1, 2, 3}}, 0, NO_HIT, &index, NULL);
    CHECK_REAL(q.t, NO_HIT, exactly());
    CHECK_INT(index, -7);
}

// y = 0: triangles 1 and 3 both at x = 3 exactly. And in the plane x = 2 itself.
static void nearest_ties(void) {
    check_hand((ray){{0, 0, 0}, {1, 0, 0}}, 0, NO_HIT, 3, 1, "1 and 3 are both hit at t = 3");
    check_hand((ray){{6, 0, 0}, {-1, 0, 0}}, 0, NO_HIT, 1, 2, "2 at t = 1");
    rng g = check_rng(1310);
    for (int i = 0; i < 40; i++) { // copies on both sides of planes, and everywhere
        mesh m = tree_soup(60, i % 2 ? tree_copies : tree_bricks, &g);
        void *tree = by_kd_tree.build(&m);
        tree_case c = kd_case;
        c.scene = "many at the same t", c.m = &m, c.tree = tree;
        tree_agrees_on_aim(&c, AT_ANYTHING, 300, &g);
        tree_agrees_on_aim(&c, ON_AXIS, 300, &g);
        by_kd_tree.free(tree);
        mesh_free(&m);
    }
}

// The walk ends: rays along a row of walls meet the first one and ask for no more than a few.
static void nearest_ends(void) {
    enum { WALLS = 400 };
    static vec3 points[3 * WALLS];
    static int corners[WALLS][3];
    for (int i = 0; i < WALLS; i++) {
        const real x = (real)i;
        points[3 * i] = (vec3){x, -1, -1}, points[3 * i + 1] = (vec3){x, 3, -1};
        points[3 * i + 2] = (vec3){x + (real)0.5, -1, 3};
        for (int c = 0; c < 3; c++) corners[i][c] = 3 * i + c;
    }
    const mesh m = {.points = points, .corners = (const int(*)[3])corners, .count = WALLS};
    kd_tree k = kd_build(&m, kd_defaults);
    for (int i = 0; i < WALLS; i += 37) {
        effort spent = {0, 0};
        int index = -1;
        const ray r = {{(real)i - (real)0.25, (real)0.1, (real)0.2}, {1, 0, 0}};
        given("%d walls across x, one behind the other; the ray begins before wall %d\n"
              "ray O = " VEC ", d = " VEC,
              WALLS, i, ARG(r.O), ARG(r.d));
        const real t = kd_nearest(&k, r, 0, NO_HIT, &index, &spent).t;
        int first = -1;
        const real want = mesh_hit(&m, r, 0, NO_HIT, &first).t;
        const bool right = t == want && index == i && spent.tests <= 12 && spent.steps >= 3;
        const char *blame = right ? NULL : kd_blame(&k);
        hint_instead(blame ? blame : tree_hint(&m, r, t, want, index, -1));
        suspect_value("untouched: a miss", -1);
        check_int(__FILE__, __LINE__, "kd_nearest(tree, r, 0, NO_HIT, &index, &spent); index",
                  index, i);
        hint_instead(blame ? blame
                           : "Does the near child come first, and the far one wait (o.first, "
                             "o.near, o.far)? Is what waits and begins behind found.limit left "
                             "out?");
        check_at_most(__FILE__, __LINE__, "spent.tests", (double)spent.tests, 12,
                      "the walk ends with the first wall: the cells behind are not asked");
        hint_instead(blame
                         ? blame
                         : "spent is not NULL here: a step for the root's box and for each "
                           "plane; kd_leaf_nearest counts the tests when it is handed spent.");
        check_words(__LINE__, spent.tests > 0, "the tests are counted", "spent.tests = %ld",
                    (long)spent.tests);
        check_words(__LINE__, spent.steps >= 3,
                    "a step is counted for each plane and for the root's box",
                    "spent.steps = %ld", (long)spent.steps);
    }
    kd_free(&k);
}

static void nearest_scenes(void) {
    rng g = check_rng(1311);
    tree_agrees_on_scenes(kd_case, 200, &g);
}

static void nearest_shapes(void) {
    rng g = check_rng(1312);
    tree_agrees_on_shapes(kd_case, 100, &g);
}

static void nearest_many(void) {
    rng g = check_rng(1313);
    tree_agrees_on_many(kd_case, 150, 1000, &g);
}

// From inside a closed mesh every ray meets it, also at edges and corners, along axes and in
// planes.
static void nearest_leaks(void) {
    mesh (*const closed[])(long) = {shape_icosphere, shape_sponge, shape_cave};
    const vec3 inside[] = {{0, 0, 0}, {(real)0.44, (real)0.45, (real)0.43}, {0, 0, 0}};
    rng g = check_rng(1314);
    for (int s = 0; s < COUNT(closed); s++) {
        mesh m = closed[s](3000);
        kd_tree k = kd_build(&m, kd_defaults);
        for (int i = 0; i < 30000; i++) {
            const triangle T = tree_some(&m, &g);
            const vec3 O = add(inside[s], scale((real)0.02, in_cube(&g)));
            const vec3 aim = i % 2 ? T.p1 : lerp(T.p1, T.p2, rng_real(&g));
            vec3 d = sub(aim, O);
            if (i % 5 == 0) d = tree_along(d, i % 3, i % 2, &g);
            if (!(dot(d, d) > 0)) continue;
            int index = -1;
            given("a closed mesh of %d triangles, from inside\nray O = " VEC ", d = " VEC
                  "\n%d rays before this one came back",
                  m.count, ARG(O), ARG(d), 30000 * s + i);
            const triangle_point q = kd_nearest(&k, (ray){O, d}, 0, NO_HIT, &index, NULL);
            if (q.t != NO_HIT && kd_any(&k, (ray){O, d}, 0, NO_HIT, NULL)) continue;
            const char *blame = kd_blame(&k);
            if (blame) hint_instead(blame);
            check_words(__LINE__, q.t != NO_HIT, "no ray leaves a closed mesh",
                        "a miss of kd_nearest");
            CHECK_BOOL(kd_any(&k, (ray){O, d}, 0, NO_HIT, NULL), true);
        }
        kd_free(&k);
        mesh_free(&m);
    }
}

// ---- whole trees ---------------------------------------------------------------------------

static void check_promises(const mesh *m, const char *name, kd_options how) {
    kd_tree k = kd_build(m, how);
    const char *flaw = kd_flaw(&k);
    given("%s: %d triangles; %ld nodes, %ld references\n%s", name, m->count, k.node_count,
          k.list_count, flaw ? flaw : "no flaw");
    if (k.count && !k.list_count) hint_instead(kd_blame(&k));
    check_words(__LINE__, flaw == NULL, "the tree keeps its promises (kd_flaw)", "%s",
                flaw ? flaw : "");
    check_words(__LINE__, kd_measure(&k).depth <= kd_depth_limit(k.count),
                "no leaf is deeper than the limit", "depth %d", kd_measure(&k).depth);
    kd_free(&k);
}

static const kd_options several[] = {
    {.step = 0.5f, .bonus = 0.2f, .budget = 16, .clip = true},
    {.step = 1, .bonus = 0, .budget = 8, .clip = false},
    {.step = 0.1f, .bonus = 0.8f, .budget = 2, .clip = true},
    {.step = 0, .bonus = 0, .budget = 100, .clip = true},
    {.step = 0.3f, .bonus = 0.5f, .budget = 1, .clip = true},
};

static void build_promises(void) {
    rng g = check_rng(1320);
    for (int i = 0; i < COUNT(tree_scenes); i++) {
        mesh m = tree_soup(tree_scenes[i].count, tree_scenes[i].make, &g);
        for (int k = 0; k < COUNT(several); k++)
            check_promises(&m, tree_scenes[i].name, several[k]);
        mesh_free(&m);
    }
    for (const shape *s = shapes; s->name; s++) {
        mesh m = s->make(2000);
        for (int k = 0; k < 3; k++) check_promises(&m, s->name, several[k]);
        mesh_free(&m);
    }
}

// Also with a budget that is spent early the walk finds the same.
static void build_options(void) {
    rng g = check_rng(1321);
    mesh m = tree_soup(120, tree_needles, &g);
    for (int k = 0; k < COUNT(several); k++) {
        kd_tree tree = kd_build(&m, several[k]);
        tree_case c = kd_case;
        c.scene = "needles, other options", c.m = &m, c.tree = &tree;
        tree_agrees_on_aim(&c, AT_ANYTHING, 1500, &g);
        kd_free(&tree);
    }
    mesh_free(&m);
}

static void build_twice(void) {
    mesh m = shape_knot(4000);
    kd_tree a = kd_build(&m, kd_defaults), b = kd_build(&m, kd_defaults);
    CHECK_INT(a.node_count, b.node_count);
    CHECK_INT(a.list_count, b.list_count);
    bool same = true;
    for (long i = 0; i < a.node_count; i++)
        same = same && a.nodes[i].packed == b.nodes[i].packed &&
               a.nodes[i].first == b.nodes[i].first;
    for (long i = 0; i < a.list_count; i++) same = same && a.lists[i] == b.lists[i];
    CHECK(same, "the same mesh gives the same tree, bit for bit");
    kd_free(&a);
    kd_free(&b);
    mesh_free(&m);
}

// A division must be worth it: how many tests a ray then needs.
static void build_pays(void) {
    mesh m = shape_knot(5000);
    kd_tree k = kd_build(&m, kd_defaults);
    rng g = check_rng(1322);
    effort spent = {0, 0};
    int index;
    for (int i = 0; i < 2000; i++)
        kd_nearest(&k, tree_aimed(&m, AT_ANYTHING, &g), 0, NO_HIT, &index, &spent);
    given("a knot of %d triangles, 2000 rays", m.count);
    const char *blame = kd_blame(&k);
    if (blame) hint_instead(blame);
    check_at_most(__FILE__, __LINE__, "triangles tested per ray", (double)spent.tests / 2000,
                  40, "far fewer than there are: 5 to 15 are usual");
    CHECK(kd_measure(&k).empty > 0, "there are empty cells");
    kd_free(&k);
    mesh_free(&m);
}

// The inspector sees what is broken.
static void build_flaws(void) {
    mesh m = shape_knot(300);
    kd_tree k = kd_build(&m, kd_defaults);
    const char *flaw = kd_flaw(&k);
    given("a knot of %d triangles", m.count);
    check_words(__LINE__, flaw == NULL, "a tree as built has no flaw", "%s", flaw ? flaw : "");
    const uint32_t listed = k.lists[0];
    k.lists[0] = (uint32_t)m.count;
    CHECK(kd_flaw(&k) != NULL, "a triangle that does not exist is a flaw");
    k.lists[0] = listed ? listed - 1 : 1;
    CHECK(kd_flaw(&k) != NULL, "another triangle in a leaf's place is a flaw");
    k.lists[0] = listed;
    k.nodes[0].split += 1000;
    CHECK(kd_flaw(&k) != NULL, "a plane outside its cell is a flaw");
    k.nodes[0].split -= 1000;
    kd_free(&k);
    mesh_free(&m);
}

static void any_scenes(void) {
    rng g = check_rng(1330);
    for (int i = 0; i < 3; i++) {
        mesh m = tree_soup(150, tree_cloud, &g);
        kd_tree k = kd_build(&m, kd_defaults);
        for (int j = 0; j < 20000; j++) {
            const ray r = tree_ray(&m, (tree_aim)(j % TREE_AIMS), &g);
            const bool want = mesh_any(&m, r, 0, 1);
            if (kd_any(&k, r, 0, 1, NULL) == want || !tree_t_is_exact) continue;
            given("a cloud\nray O = " VEC ", d = " VEC, ARG(r.O), ARG(r.d));
            CHECK_BOOL(kd_any(&k, r, 0, 1, NULL), want);
        }
        kd_free(&k);
        mesh_free(&m);
    }
}

// The others behind the interface.
static void searchers_agree(void) {
    const searcher *const all[] = {&by_brute_force, &by_bvh_median, &by_bvh_midpoint,
                                   &by_bvh_sah, &by_kd_tree};
    rng g = check_rng(1331);
    mesh m = tree_soup(150, tree_cloud, &g);
    for (int s = 0; s < COUNT(all); s++) {
        void *tree = all[s]->build(&m);
        const tree_case c = {.by = all[s],
                             .nearest = all[s]->name,
                             .any = all[s]->name,
                             .scene = "a cloud",
                             .m = &m,
                             .tree = tree,
                             .about = all[s] == &by_kd_tree ? kd_about : NULL};
        const char *flaw = all[s]->flaw(tree);
        given("%s of a cloud of %d triangles", all[s]->name, m.count);
        check_words(__LINE__, flaw == NULL, "a tree as built has no flaw", "%s",
                    flaw ? flaw : "");
        CHECK((all[s]->bytes(tree) > 0) == (s > 0), "brute force needs no memory, trees do");
        tree_agrees_on_aim(&c, AT_ANYTHING, 1500, &g);
        effort spent = {0, 0};
        all[s]->any(tree, tree_aimed(&m, AT_CORNER, &g), 0, NO_HIT, &spent);
        CHECK(spent.tests + spent.steps > 0, "effort is counted");
        all[s]->free(tree);
    }
    mesh_free(&m);
}

static void as_finder(void) {
    rng g = check_rng(1332);
    mesh m = tree_soup(150, tree_cloud, &g);
    kd_tree k = kd_build(&m, kd_defaults);
    const finder f = kd_finder(&k);
    mesh with = m;
    with.finder = &f;
    for (int i = 0; i < 2000; i++) {
        const ray r = tree_aimed(&m, AT_ANYTHING, &g);
        int a = -1, b = -1;
        const real t = mesh_hit(&with, r, 0, NO_HIT, &a).t;
        const real want = mesh_hit(&m, r, 0, NO_HIT, &b).t;
        given("a cloud\nray O = " VEC ", d = " VEC, ARG(r.O), ARG(r.d));
        if (t != want) suspect_value("a miss: a hit is lost", (double)NO_HIT);
        check_real(__FILE__, __LINE__, "mesh_hit(mesh with the tree, r, 0, NO_HIT, &index).t",
                   (double)t, (double)want, exactly());
        check_int(__FILE__, __LINE__, "index", a, b);
        CHECK_BOOL(mesh_any(&with, r, 0, NO_HIT), b >= 0);
    }
    kd_free(&k);
    mesh_free(&m);
}

#endif
