// 12-bvh-scenes.h: the part of 12-bvh.c with trees over meshes that are hard on them, and rays.
#ifndef TESTS_12_BVH_SCENES_H
#define TESTS_12_BVH_SCENES_H

#include <string.h>

#include "chapters/12-bvh/bvh.h"
#include "tests/12-bvh-boxes.h"
#include "tests/check-scenes.h"

// ---- trees -----------------------------------------------------------------------------

static const char *const rule_names[] = {"SPLIT_MEDIAN", "SPLIT_MIDPOINT", "SPLIT_SAH",
                                         "SPLIT_SWEEP"};
enum { RULES = 4 };

static bvh tree_of(const mesh *m, split_rule rule, int leaf_size) {
    return bvh_build(m, (bvh_options){rule, leaf_size, 16, TEST_WATERTIGHT});
}

// One tree by each rule.
typedef struct {
    bvh b[RULES];
} forest;

static forest forest_of(const mesh *m) {
    forest f;
    for (int rule = 0; rule < RULES; rule++) f.b[rule] = tree_of(m, (split_rule)rule, 1 + rule);
    return f;
}

static void forest_free(forest *f) {
    for (int rule = 0; rule < RULES; rule++) bvh_free(&f->b[rule]);
}

// ---- rays ------------------------------------------------------------------------------

typedef enum {
    AT_ANYTHING, // from anywhere, also from inside
    AT_CORNER,   // of a triangle
    AT_EDGE,
    FROM_FACE, // begins on a triangle
    ON_AXIS,   // along an axis through a corner, in the sides of its boxes: two components ±0
    IN_PLANE,  // one component ±0, through a corner
    AIMS
} aim12;

static vec3 some_corner(const mesh *m, int k, int which) {
    const triangle T = mesh_triangle(m, k);
    return which == 0 ? T.p1 : which == 1 ? T.p2 : T.p3;
}

// Of a triangle that is finite, if there is one.
static int some_triangle(const bvh *b, rng *g) {
    return b->order[rng_bits(g) % (uint32_t)b->count];
}

// What is as far from p as triangle T is large, or up to a thousand times further.
static vec3 eye_near(vec3 p, triangle T, rng *g) {
    const aabb box = aabb_of(T);
    const vec3 e = sub(box.max, box.min);
    const real size = fmax(e.x, fmax(e.y, e.z)) * (real)pow(10, between(g, 0, 2));
    return add(p, scale(size, in_cube(g)));
}

static real signed_zero(rng *g) {
    return chance(g, 0.5) ? (real)0.0 : -(real)0.0;
}

static ray aimed12(const bvh *b, aim12 aim, rng *g) {
    const int k = some_triangle(b, g);
    const triangle T = mesh_triangle(b->m, k);
    const int corner = (int)whole_between(g, 0, 2);
    const vec3 p = some_corner(b->m, k, corner), q = some_corner(b->m, k, (corner + 1) % 3);
    const vec3 eye = eye_near(p, T, g), s = in_cube(g);
    const real share = rng_real(g);
    const vec3 inside = lerp(lerp(T.p1, T.p2, share), T.p3, rng_real(g));
    switch (aim) {
    case AT_CORNER:
        return (ray){eye, sub(p, eye)};
    case AT_EDGE:
        return (ray){eye, sub(lerp(p, q, share), eye)};
    case FROM_FACE:
        return (ray){inside, s};
    case ON_AXIS: {
        const real a = signed_zero(g), c = signed_zero(g);
        const vec3 x = {s.x, a, c}, y = {a, s.y, c}, z = {a, c, s.z};
        const vec3 d = corner == 0 ? x : corner == 1 ? y : z;
        return (ray){sub(p, mul(absolute(d), scale(4, absolute(sub(eye, p))))), d};
    }
    case IN_PLANE: {
        const real a = signed_zero(g);
        const vec3 d = corner == 0   ? (vec3){a, s.y, s.z}
                       : corner == 1 ? (vec3){s.x, a, s.z}
                                     : (vec3){s.x, s.y, a};
        return (ray){sub(p, scale(4 * rng_real(g), mul(absolute(d), sub(eye, p)))), d};
    }
    default:
        return chance(g, 0.3) ? (ray){eye, s} : (ray){eye, sub(inside, eye)};
    }
}

static ray from_origin(const bvh *b, rng *g) {
    const triangle T = mesh_triangle(b->m, some_triangle(b, g));
    const real share = rng_real(g);
    return (ray){{0, 0, 0}, lerp(lerp(T.p1, T.p2, share), T.p3, rng_real(g))};
}

// |d| is anything from 1e-10 to 1e10, now and then.
static ray any_ray(const bvh *b, aim12 aim, rng *g) {
    if (b->count == 0) {
        const vec3 O = in_cube(g), d = in_cube(g);
        return (ray){O, d};
    }
    ray r = aimed12(b, aim, g);
    if (chance(g, 0.2)) r.d = scale((real)pow(10, between(g, -10, 10)), r.d);
    return r;
}

#endif
