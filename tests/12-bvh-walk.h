// 12-bvh-walk.h: the part of 12-bvh.c about the walks through a tree.
#ifndef TESTS_12_BVH_WALK_H
#define TESTS_12_BVH_WALK_H

#include <stdlib.h>

#include "chapters/12-bvh/leaf.h"
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
    const bool tie = index >= 0 && index < s->m->count && is_tie(s, q, index);
    if (tie)
        suspect_value("another triangle at the same t: of these the smallest index counts",
                      index);
    if (!tie && want_index >= 0 && want_index < b->count)
        suspect_value("order[found.index]: found.index is the mesh's already",
                      b->order[want_index]);
    check_int(__FILE__, __LINE__, "index, after " NEAREST_CALL, index, want_index);
    check_real(__FILE__, __LINE__, NEAREST_CALL ".u", (double)q.u, (double)want.u, exactly());
    check_real(__FILE__, __LINE__, NEAREST_CALL ".v", (double)q.v, (double)want.v, exactly());
    CHECK(signbit(q.u) == signbit(want.u) && signbit(q.v) == signbit(want.v),
          "u and v are the same bit for bit, the sign of 0 too");
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
    for (int i = 0; i < COUNT(tree_scenes); i++) {
        mesh m = tree_soup(tree_scenes[i].count, tree_scenes[i].make, g);
        forest f = forest_of(&m);
        if (tree_scenes[i].from_origin) {
            check_from_origin(ask, tree_scenes[i].name, &m, &f, g);
            forest_free(&f);
            mesh_free(&m);
            continue;
        }
        for (int aim = 0; aim < AIMS; aim++)
            check_aim(ask, tree_scenes[i].name, &m, &f, (aim12)aim, 400, g);
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
        mesh m = tree_soup((int)whole_between(g, 2, 12), tree_cloud, g);
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
    mesh m = tree_soup(4, of_stack, &g);
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
    mesh m = tree_soup(200, tree_cloud, &g);
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

// Also seen when the walk crashes.
#define DEEPEST \
    "a tree as deep as BVH_DEPTH (is your stack large enough for that? SAN=1 tells); here"

// Two leaves on each level of a tree made by hand, but one of them is inner: a chain of single
// triangles across the z axis, at z = 1, 2, 3 … It goes on to the left, nearer, or to the right.
// Only one of the triangles is hit, though every box is met: whichever child a walk takes
// first, there is a chain and a ray along which it goes down the chain and leaves a
// node behind on every level.
enum { CHAIN = BVH_DEPTH + 1 };

static triangle of_chain(int i, rng *g) {
    const real z = (real)(i + 1);
    (void)g;
    return (triangle){{-1, 1, z}, {1, 1, z + (real)0.25}, {-1, -1, z + (real)0.5}};
}

static aabb box_of_links(const mesh *m, int from, int to) {
    aabb box = aabb_empty;
    for (int i = from; i < to; i++) box = aabb_join(box, aabb_of(mesh_triangle(m, i)));
    return box;
}

typedef struct {
    mesh m;
    bvh_node nodes[2 * CHAIN];
    triangle triangles[CHAIN];
    int order[CHAIN];
    bvh b;
} chain12;

static void chain_make(chain12 *c, bool right, int aim) {
    c->m = tree_soup(CHAIN, of_chain, NULL);
    ((vec3 *)c->m.points)[3 * aim] = (vec3){1, -1, (real)(aim + 1)};
    c->b = (bvh){&c->m, c->nodes, 2, c->triangles, c->order, CHAIN, TEST_WATERTIGHT};
    c->nodes[1] = (bvh_node){aabb_empty, 0, 0};
    for (int from = 0, to = CHAIN, node = 0; from < to;) { // what is left: from … to - 1
        const bool last = to - from == 1;
        c->nodes[node] = (bvh_node){box_of_links(&c->m, from, to),
                                    last ? from : c->b.node_count, last ? 1 : 0};
        if (last) break;
        const int alone = right ? from++ : --to, pair = c->b.node_count;
        c->nodes[pair + !right] = (bvh_node){box_of_links(&c->m, alone, alone + 1), alone, 1};
        node = pair + right;
        c->b.node_count += 2;
    }
    for (int i = 0; i < CHAIN; i++) {
        c->order[i] = i;
        c->triangles[i] = mesh_triangle(&c->m, i);
    }
}

static void check_chain(question ask, const chain12 *c, ray r) {
    const search12 s = {DEEPEST, &c->m, r, 0, NO_HIT};
    int index = -1;
    given(DEEPEST " %d triangles in a row", CHAIN);
    const triangle_point want = mesh_hit(&c->m, r, 0, NO_HIT, &index);
    if (ask == NEAREST)
        check_nearest(&s, &c->b, want, index);
    else
        check_any(&s, &c->b, want.t != NO_HIT);
}

static void walk_chains(question ask) {
    static chain12 c;
    const vec3 O = {(real)0.5, (real)-0.25, 0}, d = {(real)0x1p-10, 0, 1};
    for (int i = 0; i < 2 * CHAIN; i++) {
        chain_make(&c, i % 2, i / 2);
        CHECK(bvh_measure(&c.b).depth == BVH_DEPTH && !bvh_flaw(&c.b), "the tree is a tree");
        check_chain(ask, &c, (ray){O, d});
        check_chain(ask, &c, (ray){add(O, scale(64, d)), neg(d)});
        mesh_free(&c.m);
    }
}

// A ray of the deepest tree, from its deep end: both children of every node on the way are met.
static void walk_deepest(question ask) {
    rng g = check_rng(1239);
    mesh m = tree_soup(250, tree_powers, &g);
    forest f;
    for (int rule = 0; rule < RULES; rule++) f.b[rule] = tree_of(&m, SPLIT_MIDPOINT, 1);
    given("250 triangles at powers of two, halved at the midpoint");
    CHECK_INT(bvh_measure(&f.b[0]).depth, BVH_DEPTH);
    check_from_origin(ask, DEEPEST, &m, &f, &g);
    // Past all triangles, but not their boxes: nothing makes the limit shorter.
    for (int i = 0; i < 2000; i++) {
        const vec3 d = {1, (real)(0.2 + 0.3 * rng_real(&g)), (real)(-1 - 0.1 * rng_real(&g))};
        const search12 s = {DEEPEST, &m, {{0, 0, 0}, d}, (real)1e-18, (real)1e18};
        check_search(ask, &s, &f);
    }
    forest_free(&f);
    mesh_free(&m);
    walk_chains(ask);
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

static void check_effort(const bvh *b, ray r, effort e) {
    given("%d triangles; ray O = " VEC ", d = " VEC "; %ld steps and %ld tests", b->count,
          ARG(r.O), ARG(r.d), e.steps, e.tests);
    const bool inner = b->nodes[0].count == 0;
    CHECK(e.steps >= 1 || !inner, "where there is more than one leaf, boxes are asked");
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
        given("bvh_nearest(…, &spent) gives another hit than bvh_nearest(…, NULL) for the same "
              "ray\nray O = " VEC ", d = " VEC,
              ARG(r.O), ARG(r.d));
        check_real(__FILE__, __LINE__, "bvh_nearest(tree, r, 0, NO_HIT, &index, &spent).t",
                   (double)q.t, (double)p.t, exactly());
        check_int(__FILE__, __LINE__, "index, after it", index, again);
        check_effort(b, r, e);
        const bool met = bvh_any(b, r, 0, NO_HIT, &one);
        given("ray O = " VEC ", d = " VEC "; bvh_nearest gives t = %.9g", ARG(r.O), ARG(r.d),
              (double)q.t);
        check_bool(__FILE__, __LINE__, "bvh_any(tree, r, 0, NO_HIT, &spent)", met,
                   q.t != NO_HIT);
        check_effort(b, r, one);
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
// A walk in order, and what is often left out of it.
typedef enum { NEAR_FIRST, FAR_FIRST, LEFT_FIRST, RIGHT_FIRST } child_order;
typedef struct {
    const char *looks_like;
    child_order order;
    bool shortens; // asks every box with the limit as t_max, not with t_max
    bool drops;    // leaves out what waits when it begins beyond the limit
} habit;

typedef struct {
    const bvh *b;
    habit how;
    ray r;
    slab_ray s;
    bvh_found found;
    effort spent;
} ordered_walk;

static int first_child(child_order order, const real t[2]) {
    switch (order) {
    case NEAR_FIRST:
        return t[0] > t[1];
    case FAR_FIRST:
        return t[0] <= t[1];
    default:
        return order == RIGHT_FIRST;
    }
}

static void visit_in_order(ordered_walk *w, int node) {
    const bvh_node *n = &w->b->nodes[node];
    if (n->count) {
        leaf_nearest(w->b, n, w->r, 0, &w->found, &w->spent);
        return;
    }
    const real limit = w->how.shortens ? w->found.limit : NO_HIT;
    real t[2] = {NO_HIT, NO_HIT};
    bool met[2];
    for (int i = 0; i < 2; i++)
        met[i] = aabb_hit(&w->b->nodes[n->first + i].box, &w->s, 0, limit, &t[i]);
    w->spent.steps += 2;
    const int one = met[0] && met[1] ? first_child(w->how.order, t) : !met[0], other = 1 - one;
    if (met[one]) visit_in_order(w, n->first + one);
    if (met[other] && !(w->how.drops && t[other] > w->found.limit))
        visit_in_order(w, n->first + other);
}

static void add_ordered(const bvh *b, ray r, habit how, effort *sum) {
    ordered_walk w = {b, how, r, slab_ray_of(r), bvh_nothing_found(NO_HIT), *sum};
    visit_in_order(&w, 0);
    *sum = w.spent;
}

static const habit habits[] = {
    {"a walk in order", NEAR_FIRST, true, true},
    {"the limit is not asked: aabb_hit with t_max in place of found.limit, for every box",
     NEAR_FIRST, false, true},
    {"all boxes are looked into that the ray meets: neither aabb_hit nor what waits is asked "
     "about found.limit",
     NEAR_FIRST, false, false},
    {"the farther child comes first", FAR_FIRST, true, true},
    {"the left child comes first, whatever the ray", LEFT_FIRST, true, true},
    {"the right child comes first, whatever the ray", RIGHT_FIRST, true, true},
    {"nothing is dropped when its turn comes, though it begins beyond found.limit", NEAR_FIRST,
     true, false},
};

// A walk that orders by the signs of d asks up to 1.03 times as much here; the root's box is one
// more. What each habit spends lies beyond 1.1 in one scene at least: 1.2 times the tests
// where the limit is not asked, 1.2 times the steps where nothing is dropped, 2 and more for the
// other orders.
#define ORDER_SLACK 1.1

// The habit that spends most nearly as much is the likeliest.
static void check_spent(const char *what, double got, const double spent[]) {
    int nearest = 1;
    for (int k = 2; k < COUNT(habits); k++)
        if (fabs(spent[k] - got) < fabs(spent[nearest] - got)) nearest = k;
    if (fabs(spent[nearest] - got) <= 0.02 * got)
        suspect_value(habits[nearest].looks_like, got);
    check_at_most(__FILE__, __LINE__, what, got, ORDER_SLACK * spent[0],
                  "1.1 times what a walk in order spends");
}

enum { ORDER_RAYS = 2000 };

static void check_order(const char *name, const mesh *m, bvh_options how, rng *g) {
    bvh b = bvh_build(m, how);
    effort got = {0, 0}, sum[COUNT(habits)] = {{0, 0}};
    double steps[COUNT(habits)], tests[COUNT(habits)];
    given("%s of %d triangles", name, m->count); // should it crash
    for (int i = 0; i < ORDER_RAYS; i++) {
        const vec3 eye = scale(2, generic_unit(g)), at = scale((real)0.5, in_cube(g));
        const ray r = {eye, sub(at, eye)};
        int index = -1;
        bvh_nearest(&b, r, 0, NO_HIT, &index, &got);
        for (int k = 0; k < COUNT(habits); k++) add_ordered(&b, r, habits[k], &sum[k]);
    }
    for (int k = 0; k < COUNT(habits); k++) {
        steps[k] = (double)sum[k].steps / ORDER_RAYS;
        tests[k] = (double)sum[k].tests / ORDER_RAYS;
    }
    for (int k = 0; k < 2; k++) {
        given(
            "%s of %d triangles, seen from outside by %d rays; a walk in order asks %.4g boxes "
            "and %.4g triangles per ray",
            name, m->count, ORDER_RAYS, steps[0], tests[0]);
        if (k == 0) check_spent("spent.steps, per ray", (double)got.steps / ORDER_RAYS, steps);
        if (k == 1) check_spent("spent.tests, per ray", (double)got.tests / ORDER_RAYS, tests);
    }
    bvh_free(&b);
}

// As long as the cube they are in is wide: their boxes overlap all over.
static triangle of_thicket(int i, rng *g) {
    (void)i;
    const vec3 c = in_cube(g);
    return tree_grain(c, (real)0.5, g);
}

static void nearest_order(void) {
    rng g = check_rng(1243);
    mesh cave = shape_cave(50000), sponge = shape_sponge(20000),
         thicket = tree_soup(20000, of_thicket, &g);
    check_order("a cave", &cave, bvh_defaults, &g);
    check_order("a thicket", &thicket, (bvh_options){SPLIT_MEDIAN, 1, 16, TEST_WATERTIGHT}, &g);
    check_order("a sponge", &sponge, (bvh_options){SPLIT_SAH, 1, 16, TEST_WATERTIGHT}, &g);
    mesh_free(&cave), mesh_free(&sponge), mesh_free(&thicket);
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
        const real t = bvh_nearest(b, r, 0, NO_HIT, &index, NULL).t;
        if (t != NO_HIT) continue;
        given("%s of %d triangles, from inside at an edge or corner of triangle %d\n"
              "ray O = " VEC ", d = " VEC,
              c->name, b->count, k, ARG(r.O), ARG(r.d));
        CHECK(t != NO_HIT, "a hit: no ray leaks through a closed mesh");
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
