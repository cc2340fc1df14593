// Tests of 14-octree.
#include <stdlib.h>
#include <string.h>

#include "chapters/06-bounce/bounce.h"
#include "chapters/14-octree/cell.h"
#include "tests/14-octree-scenes.h"
#include "tests/check.h"

// ---- child_of ----------------------------------------------------------------------------

static int child_by_hand(vec3 p, vec3 middle) {
    int child = 0;
    if (!(p.x < middle.x)) child += 1;
    if (!(p.y < middle.y)) child += 2;
    if (!(p.z < middle.z)) child += 4;
    return child;
}

static void suspects_of_child(vec3 p, vec3 middle) {
    const vec3 strict = {nextafter(p.x, (real)-INFINITY), nextafter(p.y, (real)-INFINITY),
                         nextafter(p.z, (real)-INFINITY)};
    const int right = child_by_hand(p, middle);
    suspect_value("the other half along each axis", 7 - right);
    if (child_by_hand(strict, middle) != right)
        suspect_value("a point on the plane put into the lower half",
                      child_by_hand(strict, middle));
    suspect_value("bit 0 taken for z and bit 2 for x",
                  (right & 2) | (right & 1) << 2 | right >> 2);
}

static void child_around(void) {
    rng g = check_rng(1401);
    for (int i = 0; i < 2000; i++) {
        const vec3 middle = in_cube(&g), p = in_cube(&g);
        given("the point " VEC ", a cell divided at " VEC, ARG(p), ARG(middle));
        suspects_of_child(p, middle);
        CHECK_INT(child_of(p, middle), child_by_hand(p, middle));
    }
}

static void child_on_plane(void) {
    rng g = check_rng(1402);
    for (int i = 0; i < 200; i++) {
        const vec3 middle = in_cube(&g), q = in_cube(&g);
        const vec3 p = {i & 1 ? middle.x : q.x, i & 2 ? middle.y : q.y, i & 4 ? middle.z : q.z};
        given("the point " VEC ", a cell divided at " VEC, ARG(p), ARG(middle));
        suspects_of_child(p, middle);
        CHECK_INT(child_of(p, middle), child_by_hand(p, middle));
    }
}

// ---- child_index ---------------------------------------------------------------------------

static int stored_below(unsigned mask, int i) {
    int count = 0;
    for (int k = 0; k < i; k++) count += is_stored(mask, k);
    return count;
}

static void index_of_all(void) {
    for (unsigned k = 0; k < 256; k++) {
        const unsigned mask = (173 + 151 * k) % 256; // all, and first one with many bits
        for (int i = 0; i < 8; i++) {
            if (!is_stored(mask, i)) continue;
            const int right = stored_below(mask, i), all = stored_below(mask, 8);
            given("mask = 0x%02x, child %d", mask, i);
            suspect_value("i itself, as if all eight were stored", i);
            suspect_value("child i counted too", right + 1);
            suspect_value("the children behind i counted", all - right - 1);
            suspect_value("all children counted", all);
            CHECK_INT(child_index(mask, i), right);
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

static bool is_front_to_back(vec3 d, const int order[8]) {
    for (int k = 0; k < 8; k++)
        for (int i = 0; i < k; i++)
            if (leads(d, order[k], order[i])) return false;
    return true;
}

static const char *order_claim(vec3 d, const int order[8]) {
    int mirrored[8], plain = 1;
    for (int k = 0; k < 8; k++) mirrored[k] = order[7 - k], plain &= order[k] == k;
    if (is_front_to_back(d, mirrored))
        return "front to back: this order is back to front, all reversed";
    if (plain) return "front to back: this is 0 to 7, whatever the signs of d";
    return "front to back: no ray goes from a later child to an earlier one";
}

static void check_order(vec3 d) {
    int order[10] = {-1, -1, -1, -1, -1, -1, -1, -1, -77, -77};
    order_children(d, order);
    given("d = " VEC ": order %d %d %d %d %d %d %d %d", ARG(d), order[0], order[1], order[2],
          order[3], order[4], order[5], order[6], order[7]);
    CHECK(order[8] == -77 && order[9] == -77, "nothing is written behind order[7]");
    CHECK(is_permutation(order), "each child once");
    CHECK(is_front_to_back(d, order), order_claim(d, order));
}

static void order_generic(void) {
    rng g = check_rng(1403);
    for (int i = 0; i < 8; i++) {
        const vec3 d = absolute(generic_unit(&g));
        check_order((vec3){i & 1 ? -d.x : d.x, i & 2 ? -d.y : d.y, i & 4 ? -d.z : d.z});
    }
    for (int i = 0; i < 500; i++) check_order(in_cube(&g));
}

static void order_zeros(void) {
    rng g = check_rng(1404);
    for (int i = 0; i < 500; i++) check_order(some_zero(in_cube(&g), &g));
    check_order((vec3){0, 0, 0});
}

static void order_uneven(void) {
    rng g = check_rng(1405);
    for (int i = 0; i < 500; i++) {
        const vec3 d = in_cube(&g);
        const double x = between(&g, -30, 30), y = between(&g, -30, 30);
        check_order((vec3){d.x * (real)pow(10, x), d.y * (real)pow(10, y), d.z});
    }
}

// ---- cell_overlaps -----------------------------------------------------------------------

#define BOXES "cell " VEC " to " VEC ", triangle " VEC ", " VEC ", " VEC
#define ARG_BOXES(c, T) ARG(c.min), ARG(c.max), ARG(T.p1), ARG(T.p2), ARG(T.p3)

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

// Is a part of T within the cell made smaller by `margin` on each side? By clipping.
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

static void overlaps_generic(void) {
    rng g = check_rng(1406);
    int with_corner = 0, without = 0;
    for (int i = 0; i < 20000; i++) {
        const double size = pow(10, between(&g, -6, 9));
        const real side = (real)(size * between(&g, 0.1, 2));
        const aabb cell = cell_at(scale((real)size, in_cube(&g)), side);
        const vec3 a = scale((real)(2 * size), in_cube(&g)),
                   b = scale((real)(2 * size), in_cube(&g)),
                   c = scale((real)(2 * size), in_cube(&g));
        const triangle T = {a, b, c};
        if (!surely_overlaps(T, cell, 1e-12 * size)) continue;
        const bool corner = surely_overlaps((triangle){a, a, a}, cell, 0) ||
                            surely_overlaps((triangle){b, b, b}, cell, 0) ||
                            surely_overlaps((triangle){c, c, c}, cell, 0);
        with_corner += corner, without += !corner;
        given(BOXES "; %s", ARG_BOXES(cell, T),
              corner ? "a corner lies in the cell" : "no corner lies in the cell");
        CHECK(cell_overlaps(T, cell), "they overlap, by clipping in higher precision");
    }
    CHECK(with_corner > 100 && without > 100, "the test has pairs of both kinds");
}

static void overlaps_apart(void) {
    rng g = check_rng(1407);
    for (int i = 0; i < 3000; i++) {
        const aabb cell = cell_at(in_cube(&g), (real)between(&g, 0.1, 1));
        const int axis = random_below(&g, 3);
        vec3 away = {0, 0, 0};
        *(axis == 0 ? &away.x : axis == 1 ? &away.y : &away.z) = random_below(&g, 2) ? 4 : -4;
        const vec3 a = in_cube(&g), b = in_cube(&g), c = in_cube(&g);
        const triangle T = {add(a, away), add(b, away), add(c, away)};
        given(BOXES, ARG_BOXES(cell, T));
        CHECK(!cell_overlaps(T, cell), "their boxes are far apart");
    }
}

// A number with few digits, so that sums of them are exact.
static real coarse(rng *g) {
    return (real)(random_below(g, 8001) - 4000) / 4096;
}
static vec3 coarse_point(rng *g) {
    const real x = coarse(g), y = coarse(g), z = coarse(g);
    return (vec3){x, y, z};
}

// Flat in a face of the cell, from either side of it.
static void overlaps_in_face(void) {
    rng g = check_rng(1408);
    for (int i = 0; i < 2000; i++) {
        const real side = (real)(1 + random_below(&g, 4000)) / 4096;
        const aabb cell = cell_at(coarse_point(&g), side);
        const int axis = i % 3;
        const vec3 inside = aabb_centre(cell);
        triangle T = {inside, add(inside, coarse_point(&g)), add(inside, coarse_point(&g))};
        const real face = along(i & 1 ? cell.min : cell.max, axis);
        vec3 *const p[3] = {&T.p1, &T.p2, &T.p3};
        for (int k = 0; k < 3; k++)
            *(axis == 0 ? &p[k]->x : axis == 1 ? &p[k]->y : &p[k]->z) = face;
        given(BOXES ": flat in a face", ARG_BOXES(cell, T));
        CHECK(cell_overlaps(T, cell),
              "a triangle in a face is in the cell, whose faces belong "
              "to it: with <= in place of < neither neighbour loses it");
    }
}

// An edge passes exactly through a corner of the cell, or a corner lies on it, and the rest is
// outside.
static void overlaps_touching(void) {
    rng g = check_rng(1409);
    for (int i = 0; i < 4000; i++) {
        const vec3 far = i % 4 == 0 ? (vec3){1000, -2000, 500} : (vec3){0, 0, 0};
        const aabb cell = cell_at(add(far, coarse_point(&g)), (real)0.25);
        const vec3 c = cell.max;
        const vec3 a = absolute(coarse_point(&g)), b = absolute(coarse_point(&g));
        const vec3 u = {a.x, -a.y, i & 1 ? a.z : -a.z};
        const triangle T = i & 2 ? (triangle){add(c, u), sub(c, u), add(c, b)}
                                 : (triangle){c, add(c, b), add(c, a)};
        given(BOXES ": %s", ARG_BOXES(cell, T),
              i & 2 ? "an edge through a corner of the cell"
                    : "a corner on a corner of the cell");
        CHECK(cell_overlaps(T, cell), "they touch in one point, and that counts");
    }
}

// ---- worth_dividing ------------------------------------------------------------------------

static const octree_options usual = {.leaf_size = 4, .depth = 12, .memory = 16};

static void worth_limits(void) {
    const int apart[8] = {3, 2, 3, 2, 3, 2, 3, 2};
    given("20 triangles, 2 or 3 in each child: at depth 11 of at most 12");
    CHECK_BOOL(worth_dividing(usual, 11, 20, apart), true);
    given("the same at depth 12, where the limit is 12: endless subdivision otherwise");
    CHECK_BOOL(worth_dividing(usual, 12, 20, apart), false);
    const octree_options loose = {.leaf_size = 20, .depth = 12, .memory = 16};
    given("20 triangles, leaf_size = 20");
    CHECK_BOOL(worth_dividing(loose, 3, 20, apart), false);
    const octree_options tight = {.leaf_size = 19, .depth = 12, .memory = 16};
    given("20 triangles, leaf_size = 19");
    CHECK_BOOL(worth_dividing(tight, 3, 20, apart), true);
    const int none[8] = {0};
    given("no triangle at all");
    CHECK_BOOL(worth_dividing((octree_options){.depth = 9}, 0, 0, none), false);
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
        given("%d triangles; %s", rows[i].count, rows[i].why);
        CHECK_BOOL(worth_dividing(usual, 3, rows[i].count, rows[i].inside), rows[i].worth);
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
    CHECK(f.leaves <= 8, "divides once at most: a division parts none of them");
    octree_free(&o);
    mesh_free(&m);
}

// ---- octree_nearest --------------------------------------------------------------------------

static octree built(const mesh *m) {
    return octree_build(m, octree_defaults);
}

// What a wrong answer looks like.
static const char *nearest_claim(probe p, triangle_point want, triangle_point got) {
    if (want.t == NO_HIT) return "nothing is hit";
    if (got.t == NO_HIT) {
        const vec3 d = p.r.d;
        if ((d.x == 0 && signbit(d.x)) || (d.y == 0 && signbit(d.y)) ||
            (d.z == 0 && signbit(d.z)))
            return "the hit that brute force finds: a component of d is -0, and 1/d is "
                   "-infinity there";
        if (d.x == 0 || d.y == 0 || d.z == 0)
            return "the hit that brute force finds: a component of d is 0";
        return "the hit that brute force finds";
    }
    if (got.t > want.t)
        return "the nearest hit: this one is further away. A triangle may be hit outside of "
               "the "
               "cell in whose list it stands, and cells before that must still be asked";
    return "a hit with t_min < t: this one is too near";
}

static void check_nearest(const octree *o, probe p, const char *where) {
    int want_index = -7, index = -7;
    const triangle_point want = mesh_hit(o->m, p.r, p.t_min, p.t_max, &want_index);
    const triangle_point got = octree_nearest(o, p.r, p.t_min, p.t_max, &index, NULL);
    if (got.t == want.t && index == want_index) return;
    given("%s; " PROBE, where, ARG_PROBE(p));
    CHECK(got.t == want.t, nearest_claim(p, want, got));
    if (want.t == NO_HIT) CHECK(index == -7, "a miss leaves *index untouched");
    suspect_value("*index was not set", -7);
    if (want.t == NO_HIT || index == -7) CHECK_INT(index, want_index);
    CHECK(index == want_index, "of two equally near triangles the one with the smaller index");
}

static void nearest_in(int first, int last, int rays, uint64_t stream) {
    rng g = check_rng(stream);
    for (int k = first; k <= last; k++) {
        mesh m = scene_rows[k].make(&g);
        octree o = built(&m);
        const aabb box = finite_box(&m);
        for (int i = 0; i < rays && !scene_rows[k].built_only; i++)
            check_nearest(&o, random_probe(&m, box, &g), scene_rows[k].name);
        octree_free(&o);
        mesh_free(&m);
    }
}

static void nearest_few(void) {
    nearest_in(0, 2, 1000, 1410);
}
static void nearest_soup(void) {
    nearest_in(3, 3, 4000, 1411);
}
static void nearest_adversarial(void) {
    nearest_in(4, COUNT(scene_rows) - 1, 1000, 1412);
}

static void nearest_minus_zero(void) {
    rng g = check_rng(1413);
    mesh m = scene_soup(&g);
    octree o = built(&m);
    for (int i = 0; i < 3000; i++) {
        const int axis = i % 3;
        vec3 d = {(real)-0.0, (real)-0.0, (real)-0.0};
        *(axis == 0 ? &d.x : axis == 1 ? &d.y : &d.z) = i & 1 ? 1 : -1;
        const vec3 O = add(point_of(&m, &g), scale(-3, d));
        check_nearest(&o, (probe){{O, d}, 0, NO_HIT}, "a soup");
    }
    octree_free(&o);
    mesh_free(&m);
}

static void nearest_inside(void) {
    rng g = check_rng(1414);
    mesh m = shape_cave(2000);
    octree o = built(&m);
    for (int i = 0; i < 1000; i++) {
        const ray r = {scale((real)0.2, in_cube(&g)),
                       scale((real)between(&g, 0.1, 10), in_cube(&g))};
        check_nearest(&o, (probe){r, 0, NO_HIT}, "from inside a cave");
    }
    octree_free(&o);
    mesh_free(&m);
}

// Of equal triangles the first; also when the ray comes to another of them earlier.
static void nearest_ties(void) {
    rng g = check_rng(1415);
    mesh m = scene_coincident(&g);
    octree o = built(&m);
    const aabb box = finite_box(&m);
    for (int i = 0; i < 3000; i++)
        check_nearest(&o, random_probe(&m, box, &g), "the same triangles again");
    octree_free(&o);
    mesh_free(&m);
}

// In a closed mesh every ray from inside hits, also those through edges and corners.
static void nearest_closed(void) {
    rng g = check_rng(1416);
    mesh m = shape_cave(3000);
    octree o = built(&m);
    for (int i = 0; i < 20000; i++) {
        const vec3 O = scale((real)0.1, in_cube(&g)), aim = point_of(&m, &g);
        int index = -1;
        given("inside a cave; ray O = " VEC ", d = " VEC, ARG(O), ARG(sub(aim, O)));
        CHECK(octree_nearest(&o, (ray){O, sub(aim, O)}, 0, NO_HIT, &index, NULL).t != NO_HIT,
              "no ray leaves a closed mesh, not through its edges either");
    }
    octree_free(&o);
    mesh_free(&m);
}

// Children asked by a walk that knows t beforehand: those of each cell that the ray enters by t.
static long needed_steps(const octree *o, const octree_node *n, aabb cell, const slab_ray *s,
                         real t_max) {
    real t;
    if (!aabb_hit(&cell, s, 0, t_max, &t)) return 1;
    long steps = 1;
    if (is_leaf(n)) return steps;
    const octree_node *child = &o->nodes[n->first];
    for (int i = 0; i < 8; i++)
        if (is_stored(stored_children(n), i))
            steps += needed_steps(o, child++, cell_child(cell, i), s, t_max);
    return steps;
}

static void nearest_steps(void) {
    rng g = check_rng(1417);
    mesh m = shape_cloud(3000);
    octree o = built(&m);
    for (int i = 0; i < 2000; i++) {
        const vec3 O = scale(3, generic_unit(&g)), d = sub(scale((real)0.5, in_cube(&g)), O);
        const slab_ray s = slab_ray_of((ray){O, d});
        int index = 0;
        effort spent = {1000, 0};
        const real t = octree_nearest(&o, (ray){O, d}, 0, NO_HIT, &index, &spent).t;
        const real reach = t == NO_HIT ? t : t * (1 + 16 * REAL_EPSILON);
        const long needed = needed_steps(&o, o.nodes, o.cube, &s, reach);
        given("a cloud; ray O = " VEC ", d = " VEC ", hit at t = %.9g", ARG(O), ARG(d),
              (double)t);
        CHECK(spent.steps > 1000, "steps are added to what *spent held");
        CHECK_AT_MOST(spent.steps - 1000, needed,
                      "the cells that begin before the hit, and their brothers: nearer cells "
                      "first, and none that begins beyond the hit");
        if (t == NO_HIT) CHECK_INT(spent.steps - 1000, needed);
    }
    octree_free(&o);
    mesh_free(&m);
}

static void nearest_deep(void) {
    rng g = check_rng(1418);
    soup s = soup_new(400);
    for (int k = 0; k < 100; k++)
        for (int i = 0; i < 4; i++)
            soup_around(&s, scale(ldexp((real)1, -k / 4), (vec3){1, 1, 1}),
                        ldexp((real)1, -k / 4 - 2), &g);
    mesh m = soup_mesh(s);
    octree o = octree_build(
        &m, (octree_options){.leaf_size = 1, .depth = OCTREE_DEPTH, .memory = 100});
    CHECK_INT(octree_measure(&o).depth, OCTREE_DEPTH);
    const aabb box = finite_box(&m);
    for (int i = 0; i < 2000; i++) check_nearest(&o, random_probe(&m, box, &g), "20 levels");
    for (int i = 0; i < 8; i++) {
        const vec3 d = {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
        check_nearest(&o, (probe){{scale(-3, d), d}, 0, NO_HIT}, "20 levels, the diagonals");
    }
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
    for (int i = 0; i < 1000; i++) {
        const probe p = random_probe(&m, finite_box(&m), &g);
        check_nearest(&dense, p, "a soup, dense");
    }
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
    static const char *const walk = "When is a hit final? Not before no cell can begin nearer.";
    static const char *const given_code = "Given code: did it change? Or an exercise above.";
    static const test tests[] = {
        {"child_of: 2000 generic points", child_around, child},
        {"child_of: on the dividing planes", child_on_plane, child},
        {"child_index: all masks", index_of_all, count},
        {"order_children: all signs", order_generic, order},
        {"order_children: components 0 and -0", order_zeros,
         "Each child must be there once, whatever d is: no division by a component."},
        {"order_children: components of very different size", order_uneven,
         "The sign decides, not the size: a sum of components forgets the small one."},
        {"cell_overlaps: far apart", overlaps_apart, overlap},
        {"cell_overlaps: against clipping in higher precision", overlaps_generic, overlap},
        {"cell_overlaps: flat in a face", overlaps_in_face, overlap},
        {"cell_overlaps: touching in one point", overlaps_touching, overlap},
        {"worth_dividing: the limits", worth_limits, worth},
        {"worth_dividing: the cost", worth_cost,
         "A step for each child with something in it, a quarter of what is inside; against "
         "testing all."},
        {"worth_dividing: coincident triangles", worth_coincident, worth},
        {"octree_nearest: none, one and two triangles", nearest_few, walk},
        {"octree_nearest: a soup", nearest_soup, walk},
        {"octree_nearest: a component of d is -0", nearest_minus_zero,
         "Did you write a slab test of your own? aabb_hit knows about -0. In order_children "
         "either half may come first."},
        {"octree_nearest: from inside", nearest_inside, walk},
        {"octree_nearest: ties", nearest_ties, "leaf_triangles settles ties, if it is asked."},
        {"octree_nearest: no more cells than needed", nearest_steps,
         "The last one pushed is looked into first. And a cell that was pushed before the hit "
         "was found may begin beyond it."},
        {"octree_nearest: 20 levels", nearest_deep,
         "At each level one cell leaves the stack and at most eight enter it."},
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
