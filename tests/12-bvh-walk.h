// 12-bvh-walk.h: the part of 12-bvh.c about the walks through a tree.
#ifndef TESTS_12_BVH_WALK_H
#define TESTS_12_BVH_WALK_H

#include <stdlib.h>

#include "tests/12-bvh-scenes.h"

// ---- agreement with brute force ----------------------------------------------------------

// What is asked.
typedef enum { NEAREST, ANY } question;

typedef struct {
    const char *scene;
    const mesh *m; // without a finder
    ray r;
    real t_min, t_max;
} search12;

static void given_search(const search12 *s, const bvh *b) {
    int index = -1;
    const triangle_point q = mesh_hit(s->m, s->r, s->t_min, s->t_max, &index);
    const bvh_figures f = bvh_measure(b);
    given("%s: %d triangles; the tree has %d leaves, the deepest at %d\n"
          "ray O = " VEC ", d = " VEC "\nt_min = %.9g, t_max = %.9g\n"
          "one after the other: t = %.9g, u = %.9g, v = %.9g, triangle %d",
          s->scene, s->m->count, f.leaves, f.depth, ARG(s->r.O), ARG(s->r.d), (double)s->t_min,
          (double)s->t_max, (double)q.t, (double)q.u, (double)q.v, index);
}

#define NEAREST_CALL "bvh_nearest(tree, r, t_min, t_max, &index, NULL)"

// Is there another triangle at the same t?
static bool is_tie(const search12 *s, triangle_point q, int index) {
    const triangle_point other =
        triangle_hit(mesh_triangle(s->m, index), s->r, s->t_min, s->t_max);
    return other.t == q.t;
}

// In float t is the true one, rounded once. In double it is off by more than the beginning of a
// box, the more the nearer O is to the triangle: nothing can be asked of an interval that ends so
// near, of a ray that begins on its triangle, or which of two equally near ones is nearer.
static const bool t_is_exact = sizeof(real) == sizeof(float);

static void check_nearest(const search12 *s, const bvh *b, triangle_point want,
                          int want_index) {
    int index = -1;
    const triangle_point q = bvh_nearest(b, s->r, s->t_min, s->t_max, &index, NULL);
    if (!memcmp(&q, &want, sizeof q) && index == want_index) return;
    if (!t_is_exact && fabs((double)(q.t - want.t)) <= 1e-9 * (double)want.t) return;
    given_search(s, b);
    if (want.t != NO_HIT) suspect_value("a miss: a hit is lost", (double)NO_HIT);
    if (q.t > want.t && q.t != NO_HIT)
        suspect_value("a hit further away: given up too early?", (double)q.t);
    check_real(__FILE__, __LINE__, NEAREST_CALL ".t", (double)q.t, (double)want.t, exactly());
    if (index >= 0 && index < s->m->count && is_tie(s, q, index))
        suspect_value("another triangle at the same t: of these the smallest index counts",
                      index);
    check_int(__FILE__, __LINE__, "index, after " NEAREST_CALL, index, want_index);
    check_real(__FILE__, __LINE__, NEAREST_CALL ".u", (double)q.u, (double)want.u, exactly());
    check_real(__FILE__, __LINE__, NEAREST_CALL ".v", (double)q.v, (double)want.v, exactly());
    CHECK(false, "t, u and v are the same, bit for bit");
}

static void check_any(const search12 *s, const bvh *b, bool want) {
    const bool got = bvh_any(b, s->r, s->t_min, s->t_max, NULL);
    if (got == want) return;
    given_search(s, b);
    check_bool(__FILE__, __LINE__, "bvh_any(tree, r, t_min, t_max, NULL)", got, want);
}

static triangle_point check_search(question ask, const search12 *s, const forest *f) {
    int index = -1;
    const triangle_point want = mesh_hit(s->m, s->r, s->t_min, s->t_max, &index);
    for (int rule = 0; rule < RULES; rule++) {
        if (ask == NEAREST)
            check_nearest(s, &f->b[rule], want, index);
        else
            check_any(s, &f->b[rule], want.t != NO_HIT);
    }
    return want;
}

static real start12(aim12 aim, ray r) {
    if (aim != FROM_FACE || t_is_exact) return 0;
    return (real)(1e-9 * wide_length(r.O) / wide_length(r.d));
}

// The same ray again, with an interval that ends or begins at the hit, unless that is at O.
static void check_cut(question ask, search12 s, const forest *f, real t, rng *g) {
    const real ends[] = {t * (real)0.9, t * (real)1.1, t, nextafter(t, NO_HIT)};
    const real starts[] = {t * (real)0.9, t * (real)1.1, t, nextafter(t, (real)0)};
    const uint32_t choices = t_is_exact ? 4 : 2;
    if (t == NO_HIT || t * wide_length(s.r.d) < 1e-6 * wide_length(s.r.O)) return;
    search12 late = s;
    s.t_max = ends[rng_bits(g) % choices];
    check_search(ask, &s, f);
    late.t_min = starts[rng_bits(g) % choices];
    check_search(ask, &late, f);
}

static void check_aim(question ask, const char *name, const mesh *m, const forest *f, aim12 aim,
                      int rays, rng *g) {
    given("%s: %d triangles", name, m->count); // should it crash
    for (int i = 0; i < rays; i++) {
        const ray r = any_ray(&f->b[0], aim, g);
        const search12 s = {name, m, r, start12(aim, r), NO_HIT};
        const triangle_point q = check_search(ask, &s, f);
        if (chance(g, 0.2)) check_cut(ask, s, f, q.t, g);
    }
}

static void check_from_origin(question ask, const char *name, const mesh *m, const forest *f,
                              rng *g) {
    given("%s: %d triangles", name, m->count);
    for (int i = 0; i < 2000; i++) {
        const search12 s = {name, m, from_origin(&f->b[0], g), (real)1e-18, (real)1e18};
        const triangle_point q = check_search(ask, &s, f);
        check_cut(ask, s, f, q.t, g);
    }
}

static void agree_on_scenes(question ask, rng *g) {
    for (int i = 0; i < COUNT(scenes12); i++) {
        mesh m = soup(scenes12[i].count, scenes12[i].make, g);
        forest f = forest_of(&m);
        if (scenes12[i].from_origin) {
            check_from_origin(ask, scenes12[i].name, &m, &f, g);
            forest_free(&f);
            mesh_free(&m);
            continue;
        }
        for (int aim = 0; aim < AIMS; aim++)
            check_aim(ask, scenes12[i].name, &m, &f, (aim12)aim, 400, g);
        forest_free(&f);
        mesh_free(&m);
    }
}

static void agree_on_shapes(question ask, rng *g) {
    for (const shape *s = shapes; s->name; s++) {
        mesh m = s->make(700);
        forest f = forest_of(&m);
        for (int aim = 0; aim < AIMS; aim++)
            check_aim(ask, s->name, &m, &f, (aim12)aim, 200, g);
        forest_free(&f);
        mesh_free(&m);
    }
}

// Few triangles, many rays.
static void agree_on_many(question ask, rng *g) {
    for (int i = 0; i < 200; i++) {
        mesh m = soup((int)whole_between(g, 2, 12), of_cloud, g);
        forest f = forest_of(&m);
        check_aim(ask, "a few triangles", &m, &f, AT_ANYTHING, 1500, g);
        forest_free(&f);
        mesh_free(&m);
    }
}

// ---- by hand ---------------------------------------------------------------------------

// Four triangles across the z axis, at z = 3, 1, 4 and 2, each in a leaf.
static triangle of_stack(int i, rng *g) {
    static const real z[] = {3, 1, 4, 2};
    (void)g;
    const vec3 p = {-1, -2, z[i]}, q = {4, -1, z[i]}, s = {0, 5, z[i]};
    return (triangle){p, q, s};
}

static void walk_by_hand(question ask) {
    rng g = check_rng(1230);
    mesh m = soup(4, of_stack, &g);
    forest f = forest_of(&m);
    const ray r = {{0.25f, 0.5f, 0}, {0, 0, 1}}, back = {{0.25f, 0.5f, 8}, {0, 0, -2}};
    const search12 rows[] = {
        {"triangles at z = 3, 1, 4, 2", &m, r, 0, NO_HIT},
        {"triangles at z = 3, 1, 4, 2", &m, back, 0, NO_HIT},
        {"triangles at z = 3, 1, 4, 2", &m, r, 1, NO_HIT},
        {"triangles at z = 3, 1, 4, 2", &m, r, 2.5f, NO_HIT},
        {"triangles at z = 3, 1, 4, 2", &m, r, 4, NO_HIT},
        {"triangles at z = 3, 1, 4, 2", &m, r, 0, 1},
        {"triangles at z = 3, 1, 4, 2", &m, r, 0, 0.5f},
        {"triangles at z = 3, 1, 4, 2", &m, r, 3, 3.5f},
        {"triangles at z = 3, 1, 4, 2", &m, {{9, 0, 0}, {0, 0, 1}}, 0, NO_HIT},
    };
    for (int i = 0; i < COUNT(rows); i++) check_search(ask, &rows[i], &f);
    forest_free(&f);
    mesh_free(&m);
}

static void nearest_by_hand(void) {
    walk_by_hand(NEAREST);
}
static void any_by_hand(void) {
    walk_by_hand(ANY);
}

// ---- the tests of both --------------------------------------------------------------------

static void nearest_many(void) {
    rng g = check_rng(1231);
    agree_on_many(NEAREST, &g);
}
static void any_many(void) {
    rng g = check_rng(1232);
    agree_on_many(ANY, &g);
}
static void nearest_scenes(void) {
    rng g = check_rng(1233);
    agree_on_scenes(NEAREST, &g);
}
static void any_scenes(void) {
    rng g = check_rng(1234);
    agree_on_scenes(ANY, &g);
}
static void nearest_shapes(void) {
    rng g = check_rng(1235);
    agree_on_shapes(NEAREST, &g);
}
static void any_shapes(void) {
    rng g = check_rng(1236);
    agree_on_shapes(ANY, &g);
}

// Every triangle three times, and rays at corners and edges, where several meet.
static void nearest_ties(void) {
    rng g = check_rng(1237);
    mesh flake = shape_sphereflake(500);
    const mesh thrice = {
        flake.points,    NULL,           mesh_room(3L * flake.count, sizeof(int[3])),
        3 * flake.count, {{0, 0, 0}, 0}, NULL};
    for (int i = 0; i < thrice.count; i++) // in another order each time
        memcpy((int *)thrice.corners[i], flake.corners[i * 7L % flake.count], sizeof(int[3]));
    forest f = forest_of(&thrice);
    for (int aim = AT_ANYTHING; aim <= AT_EDGE; aim++)
        check_aim(NEAREST, "every triangle three times", &thrice, &f, (aim12)aim, 500, &g);
    forest_free(&f);
    free((void *)thrice.corners);
    mesh_free(&flake);
}

// What is not hit leaves index alone, and t_min = t_max leaves nothing to hit.
static void nearest_misses(void) {
    rng g = check_rng(1238);
    mesh m = soup(200, of_cloud, &g);
    bvh b = tree_of(&m, SPLIT_SAH, 4);
    for (int i = 0; i < 2000; i++) {
        const vec3 O = add(in_cube(&g), (vec3){5, 0, 0}), s = in_cube(&g);
        const ray away = {O, {fabs(s.x), s.y, s.z}}, r = any_ray(&b, AT_ANYTHING, &g);
        int index = 4711;
        given("a ray that leads away from the cloud: O = " VEC ", d = " VEC, ARG(away.O),
              ARG(away.d));
        CHECK_REAL(bvh_nearest(&b, away, 0, NO_HIT, &index, NULL).t, NO_HIT, exactly());
        CHECK_INT(index, 4711);
        given("t_min = t_max = 1");
        CHECK_REAL(bvh_nearest(&b, r, 1, 1, &index, NULL).t, NO_HIT, exactly());
        CHECK_INT(index, 4711);
    }
    bvh_free(&b);
    mesh_free(&m);
}

// A ray of the deepest tree, from its deep end: both children of every node on the way are met.
static void walk_deepest(question ask) {
    rng g = check_rng(1239);
    mesh m = soup(250, of_powers, &g);
    forest f;
    for (int rule = 0; rule < RULES; rule++) f.b[rule] = tree_of(&m, SPLIT_MIDPOINT, 1);
    given("250 triangles at powers of two, halved at the midpoint");
    CHECK_INT(bvh_measure(&f.b[0]).depth, BVH_DEPTH);
    check_from_origin(ask, "a tree as deep as BVH_DEPTH", &m, &f, &g);
    // Past all triangles, but not their boxes: nothing makes the limit shorter.
    for (int i = 0; i < 2000; i++) {
        const vec3 d = {1, (real)(0.2 + 0.3 * rng_real(&g)), (real)(-1 - 0.1 * rng_real(&g))};
        const search12 s = {
            "a tree as deep as BVH_DEPTH", &m, {{0, 0, 0}, d}, (real)1e-18, (real)1e18};
        check_search(ask, &s, &f);
    }
    forest_free(&f);
    mesh_free(&m);
}

static void nearest_deepest(void) {
    walk_deepest(NEAREST);
}
static void any_deepest(void) {
    walk_deepest(ANY);
}

// ---- effort ------------------------------------------------------------------------------

typedef struct {
    effort nearest, any;
    int rays;
} tally12;

static void check_effort(const bvh *b, ray r, effort e, bool same_hit) {
    given("%d triangles; ray O = " VEC ", d = " VEC "; %ld steps and %ld tests", b->count,
          ARG(r.O), ARG(r.d), e.steps, e.tests);
    CHECK(same_hit, "counting changes nothing");
    CHECK(e.steps >= 1, "the root's box is asked, at least");
    CHECK(e.steps < b->node_count, "no box is asked twice");
    CHECK(e.tests >= 0 && e.tests <= b->count, "no triangle is asked twice");
}

static tally12 spent_on(const bvh *b, int rays, rng *g) {
    tally12 sum = {{0, 0}, {0, 0}, rays};
    for (int i = 0; i < rays; i++) {
        const vec3 eye = scale(2, generic_unit(g)), at = scale((real)0.5, in_cube(g));
        const ray r = {eye, sub(at, eye)};
        int index = -1, again = -1;
        effort e = {1000, 1000}, one = {0, 0};
        const triangle_point q = bvh_nearest(b, r, 0, NO_HIT, &index, &e);
        const triangle_point p = bvh_nearest(b, r, 0, NO_HIT, &again, NULL);
        e.steps -= 1000, e.tests -= 1000;
        check_effort(b, r, e, q.t == p.t && index == again);
        const bool met = bvh_any(b, r, 0, NO_HIT, &one);
        check_effort(b, r, one, met == (q.t != NO_HIT));
        sum.nearest.steps += e.steps, sum.nearest.tests += e.tests;
        sum.any.steps += one.steps, sum.any.tests += one.tests;
    }
    return sum;
}

static tally12 spent_on_shape(mesh (*make)(long), long triangles, rng *g) {
    mesh m = make(triangles);
    bvh b = tree_of(&m, SPLIT_SAH, 4);
    const tally12 sum = spent_on(&b, 500, g);
    bvh_free(&b);
    mesh_free(&m);
    return sum;
}

// Four times as many triangles: two more levels to go down, and not four times the work. In
// order and with a shorter limit a ray asks about 40 boxes here, without about 200.
static void check_growth(question ask) {
    rng g = check_rng(1240);
    const tally12 few = spent_on_shape(shape_sphereflake, 5000, &g),
                  many = spent_on_shape(shape_sphereflake, 80000, &g);
    const effort a = ask == NEAREST ? few.nearest : few.any,
                 b = ask == NEAREST ? many.nearest : many.any;
    given("a sphereflake of 5000 triangles: %.1f steps and %.1f tests per ray; of 80,000: %.1f "
          "and %.1f",
          (double)a.steps / few.rays, (double)a.tests / few.rays, (double)b.steps / many.rays,
          (double)b.tests / many.rays);
    CHECK_AT_MOST((double)b.tests / many.rays, 800,
                  "a hundredth of the triangles: most are in boxes that the ray misses");
    CHECK_AT_MOST((double)b.steps / many.rays, 1600, "and so are most of the boxes");
    CHECK_AT_MOST((double)(b.steps + b.tests) / (double)(a.steps + a.tests), 6,
                  "16 times the triangles, and far less than 16 times the work");
}

static void nearest_effort(void) {
    check_growth(NEAREST);
}
static void any_effort(void) {
    check_growth(ANY);
}

// ---- as a finder -----------------------------------------------------------------------

static void finder_of_mesh(void) {
    rng g = check_rng(1241);
    mesh m = shape_knot(2000);
    bvh b = tree_of(&m, SPLIT_SAH, 4);
    const finder f = bvh_finder(&b);
    mesh with = m;
    with.finder = &f;
    for (int i = 0; i < 2000; i++) {
        const ray r = any_ray(&b, (aim12)(i % AIMS), &g);
        int one = -1, other = -1;
        const real t_min = start12(FROM_FACE, r);
        const triangle_point q = mesh_hit(&m, r, t_min, NO_HIT, &one),
                             p = mesh_hit(&with, r, t_min, NO_HIT, &other);
        given("mesh_hit and mesh_any of a knot, with the tree as their finder");
        CHECK(!memcmp(&p, &q, sizeof p) && one == other, "the same hit as without");
        CHECK_BOOL(mesh_any(&with, r, t_min, NO_HIT), q.t != NO_HIT);
    }
    bvh_free(&b);
    mesh_free(&m);
}

// ---- leaks -------------------------------------------------------------------------------

// A point inside each closed shape, around which a little room is inside too.
typedef struct {
    const char *name;
    mesh (*make)(long);
    vec3 eye;
    real room;
} closed12;
static const closed12 closed_shapes[] = {
    {"icosphere", shape_icosphere, {0, 0, 0}, (real)0.3},
    {"cave", shape_cave, {0, 0, 0}, (real)0.05},
    {"knot", shape_knot, {(real)0.83, 0, 0}, (real)0.05},
    {"sponge", shape_sponge, {(real)0.49, (real)0.49, (real)0.49}, (real)0.002},
};

static void check_sealed(const closed12 *c, const bvh *b, long rays, rng *g) {
    for (long i = 0; i < rays; i++) {
        const int k = some_triangle(b, g), corner = (int)whole_between(g, 0, 2);
        const vec3 O = add(c->eye, scale(c->room, in_cube(g)));
        const vec3 p = some_corner(b->m, k, corner), q = some_corner(b->m, k, (corner + 1) % 3);
        const vec3 at = chance(g, 0.3) ? p : lerp(p, q, rng_real(g));
        const ray r = {O, sub(at, O)};
        int index;
        if (bvh_nearest(b, r, 0, NO_HIT, &index, NULL).t != NO_HIT) continue;
        given("%s of %d triangles, from inside at an edge or corner of triangle %d\n"
              "ray O = " VEC ", d = " VEC,
              c->name, b->count, k, ARG(r.O), ARG(r.d));
        CHECK(false, "the ray does not leak through a closed mesh");
    }
}

// LEAK_RAYS=1e8 in the environment: so many (make leaks).
static long leak_rays(void) {
    const char *wanted_rays = getenv("LEAK_RAYS");
    const double n = wanted_rays ? atof(wanted_rays) : 0;
    return n >= 1 ? (long)n : 200000;
}

static void nearest_sealed(void) {
    rng g = check_rng(1242);
    for (int i = 0; i < COUNT(closed_shapes); i++) {
        mesh m = closed_shapes[i].make(20000);
        bvh b = tree_of(&m, SPLIT_SAH, 4);
        check_sealed(&closed_shapes[i], &b, leak_rays() / COUNT(closed_shapes), &g);
        bvh_free(&b);
        mesh_free(&m);
    }
}

#endif
