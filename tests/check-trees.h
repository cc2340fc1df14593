// check-trees.h: rays that are hard on a walk, and whether a searcher finds what brute force
// finds, bit for bit.
#ifndef TESTS_CHECK_TREES_H
#define TESTS_CHECK_TREES_H

#include <string.h>

#include "chapters/13-kd-tree/searcher.h"
#include "tests/check-scenes.h"
#include "tests/check.h"

// ---- rays ----------------------------------------------------------------------------------

typedef enum {
    AT_ANYTHING, // from anywhere, also from inside
    AT_CORNER,
    AT_EDGE,
    FROM_FACE, // begins on a triangle
    ON_AXIS,   // along an axis through a corner: two components ±0, in planes
    IN_PLANE,  // one component ±0, through a corner
    TREE_AIMS
} tree_aim;

static inline triangle tree_some(const mesh *m, rng *g) {
    triangle T = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (int i = 0; i < 100 && m->count; i++) {
        T = mesh_triangle(m, tree_whole(g, m->count));
        if (is_finite(T.p1) && is_finite(T.p2) && is_finite(T.p3)) break;
    }
    return T;
}

// v with one component, or all but it, ±0.
static inline vec3 tree_along(vec3 v, int axis, bool all_but, rng *g) {
    real c[3] = {v.x, v.y, v.z};
    for (int k = 0; k < 3; k++)
        if ((k == axis) != all_but) c[k] = rng_bits(g) & 1 ? (real)0.0 : -(real)0.0;
    return (vec3){c[0], c[1], c[2]};
}

static inline ray tree_aimed(const mesh *m, tree_aim aim, rng *g) {
    const triangle T = tree_some(m, g);
    const int axis = tree_whole(g, 3);
    const vec3 p = axis == 0 ? T.p1 : axis == 1 ? T.p2 : T.p3, q = axis == 0 ? T.p2 : T.p3;
    const vec3 e = sub(aabb_of(T).max, aabb_of(T).min), s = in_cube(g);
    const real share = rng_real(g),
               size = fmax(e.x, fmax(e.y, e.z)) * (real)pow(10, between(g, 0, 2));
    const vec3 inside = lerp(lerp(T.p1, T.p2, share), T.p3, rng_real(g));
    const vec3 eye = add(p, scale(size, in_cube(g)));
    if (aim == AT_CORNER) return (ray){eye, sub(p, eye)};
    if (aim == AT_EDGE) return (ray){eye, sub(lerp(p, q, share), eye)};
    if (aim == FROM_FACE) return (ray){inside, s};
    if (aim == ON_AXIS || aim == IN_PLANE) {
        const vec3 d = tree_along(s, axis, aim == ON_AXIS, g);
        return (ray){sub(p, scale(2 * share * size, d)), d};
    }
    return share < (real)0.3 ? (ray){eye, s} : (ray){eye, sub(inside, eye)};
}

// |d| is anything from 1e-10 to 1e10, now and then.
static inline ray tree_ray(const mesh *m, tree_aim aim, rng *g) {
    ray r = tree_aimed(m, aim, g);
    if (tree_whole(g, 5) == 0) r.d = scale((real)pow(10, between(g, -10, 10)), r.d);
    return r;
}

// ---- agreement with brute force --------------------------------------------------------------

typedef struct tree_case tree_case;
struct tree_case {
    const searcher *by;
    const char *nearest, *any; // how they are called: for the messages
    const char *scene;
    const mesh *m; // without a finder
    const void *tree;
    // A hint about this kind of tree when t, of triangle `got`, is not `want`; or NULL.
    const char *(*about)(const tree_case *c, ray r, real t, real want, int got);
};

// What was asked, also when it crashes or is stopped: then how many rays came back tells an
// endless walk from a slow one.
static inline void given_ray(const tree_case *c, ray r, real t_min, real t_max) {
    static long before = 0;
    given("%s: %d triangles%s\nray O = " VEC ", d = " VEC "\nt_min = %.9g, t_max = %.9g; "
          "spent = NULL\n%ld rays before this one came back",
          c->scene, c->m->count, c->m->count ? "" : ": no node, and no array of nodes",
          ARG(r.O), ARG(r.d), (double)t_min, (double)t_max, before++);
}

static inline void given_search(const tree_case *c, ray r, real t_min, real t_max) {
    int index = -1;
    const triangle_point q = mesh_hit(c->m, r, t_min, t_max, &index);
    given("%s: %d triangles\nray O = " VEC ", d = " VEC "\nt_min = %.9g, t_max = %.9g\n"
          "one after the other: t = %.9g, u = %.9g, v = %.9g, triangle %d",
          c->scene, c->m->count, ARG(r.O), ARG(r.d), (double)t_min, (double)t_max, (double)q.t,
          (double)q.u, (double)q.v, index);
}

static inline const char *tree_index_hint(const mesh *m, ray r, real t, int got,
                                          int untouched) {
    if (got == untouched) return "t is right: *index must be written with every hit.";
    if (got < 0 || got >= m->count)
        return "That is no triangle of the mesh. Where does the walk keep the nearest one's "
               "number?";
    if (triangle_hit(mesh_triangle(m, got), r, 0, NO_HIT).t != t)
        return "t is right, but not that triangle's: t and index must be of the same hit, and "
               "index the number in the mesh.";
    return "Both are hit at this t, and what waits may hold the other: all of it that does not "
           "begin beyond found.limit is asked, whatever the top of the stack says. And one "
           "found "
           "serves all leaves: of hits at the same t the smaller index counts.";
}

// A hint by the kind of failure: `got` was left in *index, which was `untouched` before.
static inline const char *tree_hint(const mesh *m, ray r, real t, real want, int got,
                                    int untouched) {
    if (want == NO_HIT && t == NO_HIT)
        return "t is right, a miss: *index must stay as it was. Write it only with a hit.";
    if (want == NO_HIT || t < want)
        return "There is no such hit with t_min < t < t_max: are both limits handed on to the "
               "leaves?";
    if (t == NO_HIT)
        return "A hit is lost. Where the ray is in both children one goes on and the other "
               "waits: does it, and is all that waits taken up again? Is the first span that "
               "of "
               "the whole tree? Is a hit thrown away because it lies behind its leaf's cell?";
    if (t > want)
        return "A leaf's triangle may be hit behind the cell's end. What may still lie before "
               "that hit? All that waits and begins before it must still be asked.";
    return tree_index_hint(m, r, t, got, untouched);
}

static inline void tree_disagrees(const tree_case *c, ray r, real t_min, real t_max,
                                  triangle_point q, int got, triangle_point want, int index) {
    given_search(c, r, t_min, t_max);
    const char *about = c->about ? c->about(c, r, q.t, want.t, got) : NULL;
    hint_instead(about ? about : tree_hint(c->m, r, q.t, want.t, got, -1));
    suspect_value("a miss: a hit is lost", (double)NO_HIT);
    if (q.t > want.t && q.t != NO_HIT)
        suspect_value("a hit further away: a nearer one waited in another cell", (double)q.t);
    check_real(__FILE__, __LINE__, c->nearest, (double)q.t, (double)want.t, exactly());
    suspect_value("-1, untouched", -1);
    if (index >= 0 && got > index && got < c->m->count &&
        triangle_hit(mesh_triangle(c->m, got), r, t_min, t_max).t == want.t)
        suspect_value("of equally near triangles the smallest index counts", got);
    check_int(__FILE__, __LINE__, "index, the triangle", got, index);
    hint_instead("t and index are right: u and v must be those of the same hit.");
    CHECK(!memcmp(&q, &want, sizeof q), "t, u and v are the same, bit for bit");
}

// Nearest and any hit of one ray. Returns t.
static inline real tree_agrees(const tree_case *c, ray r, real t_min, real t_max) {
    int index = -1, got = -1;
    const triangle_point want = mesh_hit(c->m, r, t_min, t_max, &index);
    given_ray(c, r, t_min, t_max);
    const triangle_point q = c->by->nearest(c->tree, r, t_min, t_max, &got, NULL);
    if (memcmp(&q, &want, sizeof q) || got != index)
        tree_disagrees(c, r, t_min, t_max, q, got, want, index);
    const bool any = c->by->any(c->tree, r, t_min, t_max, NULL);
    if (any != (want.t != NO_HIT)) {
        given_search(c, r, t_min, t_max);
        check_bool(__FILE__, __LINE__, c->any, any, want.t != NO_HIT);
    }
    return want.t;
}

// In float t is the true one, rounded once. In double it is off by more than where a box
// begins: nothing can be asked of an interval that ends so near, or begins on a triangle.
static const bool tree_t_is_exact = sizeof(real) == sizeof(float);

// The ray again, with an interval that ends or begins near the hit or at it.
static inline void tree_agrees_cut(const tree_case *c, ray r, real t, rng *g) {
    const int choices = tree_t_is_exact ? 4 : 2;
    const real ends[] = {t * (real)0.9, t * (real)1.1, t, nextafter(t, NO_HIT)};
    const real starts[] = {t * (real)0.9, t * (real)1.1, t, nextafter(t, (real)0)};
    if (t == NO_HIT || t * wide_length(r.d) < 1e-6 * wide_length(r.O)) return;
    tree_agrees(c, r, 0, ends[tree_whole(g, choices)]);
    tree_agrees(c, r, starts[tree_whole(g, choices)], NO_HIT);
}

static inline void tree_agrees_on_aim(const tree_case *c, tree_aim aim, int rays, rng *g) {
    for (int i = 0; i < rays; i++) {
        const ray r = tree_ray(c->m, aim, g);
        const real beside = (real)(1e-10 * (wide_length(r.O) + 1e-4) / wide_length(r.d));
        const real t_min = aim == FROM_FACE && !tree_t_is_exact ? beside : 0;
        const real t = tree_agrees(c, r, t_min, NO_HIT);
        if (i % 5 == 0) tree_agrees_cut(c, r, t, g);
    }
}

static inline void tree_agrees_from_origin(const tree_case *c, int rays, rng *g) {
    for (int i = 0; i < rays; i++) {
        const triangle T = tree_some(c->m, g);
        const real share = rng_real(g);
        const ray r = {{0, 0, 0}, lerp(lerp(T.p1, T.p2, share), T.p3, rng_real(g))};
        tree_agrees(c, r, (real)1e-18, (real)1e18);
    }
}

// With c->by, on scenes of their own.
static inline void tree_agrees_on_scenes(tree_case c, int rays, rng *g) {
    for (int i = 0; i < COUNT(tree_scenes); i++) {
        mesh m = tree_soup(tree_scenes[i].count, tree_scenes[i].make, g);
        void *tree = c.by->build(&m);
        c.scene = tree_scenes[i].name, c.m = &m, c.tree = tree;
        if (tree_scenes[i].from_origin) tree_agrees_from_origin(&c, rays, g);
        for (int aim = 0; aim < TREE_AIMS && !tree_scenes[i].from_origin; aim++)
            tree_agrees_on_aim(&c, (tree_aim)aim, rays, g);
        c.by->free(tree);
        mesh_free(&m);
    }
}

static inline void tree_agrees_on_shapes(tree_case c, int rays, rng *g) {
    for (const shape *s = shapes; s->name; s++) {
        mesh m = s->make(500);
        void *tree = c.by->build(&m);
        c.scene = s->name, c.m = &m, c.tree = tree;
        for (int aim = 0; aim < TREE_AIMS; aim++)
            tree_agrees_on_aim(&c, (tree_aim)aim, rays, g);
        c.by->free(tree);
        mesh_free(&m);
    }
}

// Few triangles, many rays, many trees.
static inline void tree_agrees_on_many(tree_case c, int trees, int rays, rng *g) {
    for (int i = 0; i < trees; i++) {
        mesh m = tree_soup(2 + tree_whole(g, 11), tree_cloud, g);
        void *tree = c.by->build(&m);
        c.scene = "a few triangles", c.m = &m, c.tree = tree;
        tree_agrees_on_aim(&c, AT_ANYTHING, rays, g);
        c.by->free(tree);
        mesh_free(&m);
    }
}

#endif
