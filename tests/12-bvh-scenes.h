// 12-bvh-scenes.h: the part of 12-bvh.c with meshes that are hard on a tree, and rays at them.
#ifndef TESTS_12_BVH_SCENES_H
#define TESTS_12_BVH_SCENES_H

#include <string.h>

#include "chapters/12-bvh/bvh.h"
#include "chapters/12-bvh/shapes.h"
#include "tests/12-bvh-boxes.h"

// ---- meshes that share no points ------------------------------------------------------

typedef triangle made_triangle(int i, rng *g);

static mesh soup(int count, made_triangle *make, rng *g) {
    if (count == 0) return (mesh){0};
    vec3 *points = mesh_room(3L * count, sizeof *points);
    int(*corners)[3] = mesh_room(count, sizeof *corners);
    for (int i = 0; i < count; i++) {
        const triangle T = make(i, g);
        points[3 * i] = T.p1, points[3 * i + 1] = T.p2, points[3 * i + 2] = T.p3;
        for (int k = 0; k < 3; k++) corners[i][k] = 3 * i + k;
    }
    return (mesh){.points = points, .corners = (const int(*)[3])corners, .count = count};
}

static triangle grain_at(vec3 c, real size, rng *g) {
    const vec3 a = scale(size, in_cube(g)), b = scale(size, in_cube(g));
    return (triangle){add(c, a), add(c, b), sub(c, scale((real)0.5, add(a, b)))};
}

static triangle of_cloud(int i, rng *g) {
    (void)i;
    const vec3 c = in_cube(g);
    return grain_at(c, (real)0.15, g);
}

// The box of each is c ± e.
static triangle of_one_centre(int i, rng *g) {
    (void)i;
    const vec3 c = {(real)0.25, (real)0.5, (real)-0.125};
    const vec3 e = {(real)whole_between(g, 1, 99) / 64, (real)whole_between(g, -99, -1) / 64,
                    (real)whole_between(g, 1, 99) / 64};
    const vec3 f = mul(e, in_cube(g));
    return (triangle){sub(c, e), add(c, e), add(c, f)};
}

static triangle of_copies(int i, rng *g) {
    (void)g;
    rng same = rng_seed(12, (uint64_t)(i * i % 7));
    return of_cloud(0, &same);
}

static triangle of_x_line(int i, rng *g) {
    return grain_at((vec3){(real)(i * 37 % 200) / 10, (real)0.5, (real)0.25}, (real)0.3, g);
}

static triangle of_diagonal(int i, rng *g) {
    const real x = (real)(i * 37 % 200) / 10;
    return grain_at((vec3){x, x, x}, (real)0.3, g);
}

// One half of each halving holds one triangle: as deep as there are triangles, were it allowed.
static triangle of_powers(int i, rng *g) {
    const real x = (real)ldexp(1, i - 125);
    return grain_at((vec3){x, x / 3, -x}, x / 8, g);
}

static triangle of_few_powers(int i, rng *g) {
    return of_powers(125 - 31 + i, g);
}

static triangle of_plane(int i, rng *g) {
    triangle T = of_cloud(i, g);
    T.p1.y = T.p2.y = T.p3.y = (real)0.3;
    return T;
}

static triangle of_giant(int i, rng *g) {
    const vec3 c = in_cube(g);
    return grain_at(c, i == 77 ? 1000 : (real)0.02, g);
}

static triangle of_far(int i, rng *g) {
    (void)i;
    const vec3 c = add(scale(8, in_cube(g)), (vec3){1000000, -1000000, 500000});
    return grain_at(c, 2, g);
}

static triangle of_tiny(int i, rng *g) {
    const triangle T = of_cloud(i, g);
    return (triangle){scale((real)1e-6, T.p1), scale((real)1e-6, T.p2),
                      scale((real)1e-6, T.p3)};
}

static triangle of_broken(int i, rng *g) {
    triangle T = of_cloud(i, g);
    if (i % 3 == 0) T.p1.x = NAN;
    if (i % 7 == 1) T.p2.y = INFINITY;
    if (i % 11 == 2) T.p3.z = -INFINITY;
    return T;
}

static triangle of_no_area(int i, rng *g) {
    triangle T = of_cloud(i, g);
    if (i % 3 == 0) T.p2 = T.p1;
    if (i % 6 == 0) T.p3 = T.p1;
    return T;
}

// A cube's edge long, in whole coordinates: sides of boxes everywhere.
static triangle of_bricks(int i, rng *g) {
    (void)i;
    const vec3 c = {(real)whole_between(g, 0, 4), (real)whole_between(g, 0, 4),
                    (real)whole_between(g, 0, 4)};
    const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int k = (int)whole_between(g, 0, 2);
    return (triangle){c, add(c, axes[k]), add(c, axes[(k + 1) % 3])};
}

static triangle of_largest(int i, rng *g) {
    (void)i;
    const vec3 c = scale((real)0.5 * REAL_MAX, in_cube(g));
    return grain_at(c, (real)0.2 * REAL_MAX, g);
}

// Seen from anywhere, some of the powers of two are points even to double, and then brute force
// guesses. From the origin all look alike.
typedef struct {
    const char *name;
    int count;
    made_triangle *make;
    bool from_origin;
} scene12;
static const scene12 scenes12[] = {
    {"no triangle", 0, of_cloud, false},
    {"one triangle", 1, of_cloud, false},
    {"two triangles", 2, of_cloud, false},
    {"two triangles at the same place", 2, of_copies, false},
    {"a cloud", 200, of_cloud, false},
    {"all centres equal", 200, of_one_centre, false},
    {"seven triangles, each many times", 200, of_copies, false},
    {"centres on a line along x", 200, of_x_line, false},
    {"centres on a diagonal", 200, of_diagonal, false},
    {"250 centres at powers of two", 250, of_powers, true},
    {"62 centres at powers of two", 62, of_few_powers, true},
    {"all in one plane", 200, of_plane, false},
    {"bricks: sides along the axes", 200, of_bricks, false},
    {"a giant among dust", 200, of_giant, false},
    {"coordinates at 1e6", 200, of_far, false},
    {"coordinates at 1e-6", 200, of_tiny, false},
    {"NaN and infinite corners", 200, of_broken, false},
    {"triangles without area", 200, of_no_area, false},
};

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
