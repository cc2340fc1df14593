// check-scenes.h: meshes that are hard on a tree.
#ifndef TESTS_CHECK_SCENES_H
#define TESTS_CHECK_SCENES_H

#include "chapters/12-bvh/shapes.h"
#include "tests/check-generic.h"

typedef triangle tree_triangle(int i, rng *g);

// Triangles that share no points.
static inline mesh tree_soup(int count, tree_triangle *make, rng *g) {
    if (count == 0) return (mesh){.count = 0};
    vec3 *points = mesh_room(3L * count, sizeof *points);
    int(*corners)[3] = mesh_room(count, sizeof *corners);
    for (int i = 0; i < count; i++) {
        const triangle T = make(i, g);
        points[3 * i] = T.p1, points[3 * i + 1] = T.p2, points[3 * i + 2] = T.p3;
        for (int k = 0; k < 3; k++) corners[i][k] = 3 * i + k;
    }
    return (mesh){.points = points, .corners = (const int(*)[3])corners, .count = count};
}

static inline int tree_whole(rng *g, int count) { // 0 to count - 1
    return (int)(rng_bits(g) % (uint32_t)count);
}

static inline triangle tree_grain(vec3 c, real size, rng *g) {
    const vec3 a = scale(size, in_cube(g)), b = scale(size, in_cube(g));
    return (triangle){add(c, a), add(c, b), sub(c, scale((real)0.5, add(a, b)))};
}

static inline triangle tree_cloud(int i, rng *g) {
    (void)i;
    const vec3 c = in_cube(g);
    return tree_grain(c, (real)0.2, g);
}

// The box of each is c ± e.
static inline triangle tree_one_centre(int i, rng *g) {
    (void)i;
    const vec3 c = {(real)0.25, (real)0.5, (real)-0.125};
    const vec3 e = scale((real)(1 + tree_whole(g, 60)) / 64, (vec3){1, (real)-0.75, (real)0.5});
    return (triangle){sub(c, e), add(c, e), add(c, mul(e, in_cube(g)))};
}

static inline triangle tree_copies(int i, rng *g) {
    (void)g;
    rng same = rng_seed(13, (uint64_t)(i * i % 7));
    return tree_cloud(0, &same);
}

static inline triangle tree_all_same(int i, rng *g) {
    (void)i;
    return tree_copies(0, g);
}

static inline triangle tree_x_line(int i, rng *g) {
    return tree_grain((vec3){(real)(i * 37 % 200) / 10, (real)0.5, (real)0.25}, (real)0.3, g);
}

static inline triangle tree_diagonal(int i, rng *g) {
    const real x = (real)(i * 37 % 200) / 10;
    return tree_grain((vec3){x, x, x}, (real)0.3, g);
}

static inline triangle tree_powers(int i, rng *g) {
    const real x = (real)ldexp(1, i - 125);
    return tree_grain((vec3){x, x / 3, -x}, x / 8, g);
}

static inline triangle tree_few_powers(int i, rng *g) {
    return tree_powers(125 - 31 + i, g);
}

static inline triangle tree_flat(int i, rng *g) {
    triangle T = tree_cloud(i, g);
    T.p1.y = T.p2.y = T.p3.y = (real)0.3;
    return T;
}

// Whole coordinates, along the axes: triangles that lie in planes, or end at them.
static inline triangle tree_bricks(int i, rng *g) {
    const vec3 c = {(real)tree_whole(g, 5), (real)tree_whole(g, 5), (real)tree_whole(g, 5)};
    const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return (triangle){c, add(c, axes[i % 3]), add(c, axes[(i + 1) % 3])};
}

// Long ones through everything: most cells cut them.
static inline triangle tree_needles(int i, rng *g) {
    (void)i;
    const vec3 a = in_cube(g), b = in_cube(g);
    return (triangle){a, b, add(b, scale((real)0.01, in_cube(g)))};
}

static inline triangle tree_giant(int i, rng *g) {
    const vec3 c = in_cube(g);
    return tree_grain(c, i == 77 ? 1000 : (real)0.02, g);
}

static inline triangle tree_far(int i, rng *g) {
    (void)i;
    const vec3 c = add(scale(8, in_cube(g)), (vec3){1000000, -1000000, 500000});
    return tree_grain(c, 2, g);
}

static inline triangle tree_tiny(int i, rng *g) {
    const triangle T = tree_cloud(i, g);
    const real s = (real)1e-6;
    return (triangle){scale(s, T.p1), scale(s, T.p2), scale(s, T.p3)};
}

static inline triangle tree_broken(int i, rng *g) {
    triangle T = tree_cloud(i, g);
    if (i % 3 == 0) T.p1.x = NAN;
    if (i % 7 == 1) T.p2.y = INFINITY;
    if (i % 11 == 2) T.p3.z = -INFINITY;
    return T;
}

static inline triangle tree_no_area(int i, rng *g) {
    triangle T = tree_cloud(i, g);
    if (i % 3 == 0) T.p2 = T.p1;
    if (i % 6 == 0) T.p3 = T.p1;
    return T;
}

static inline triangle tree_largest(int i, rng *g) {
    (void)i;
    const vec3 c = scale((real)0.5 * REAL_MAX, in_cube(g));
    return tree_grain(c, (real)0.2 * REAL_MAX, g);
}

typedef struct {
    const char *name;
    int count;
    tree_triangle *make;
    bool from_origin; // seen from elsewhere most are points, even to double
} tree_scene;

static const tree_scene tree_scenes[] = {
    {"no triangle", 0, tree_cloud, false},
    {"one triangle", 1, tree_cloud, false},
    {"two triangles", 2, tree_cloud, false},
    {"two triangles at the same place", 2, tree_all_same, false},
    {"a cloud", 200, tree_cloud, false},
    {"all centres equal", 200, tree_one_centre, false},
    {"one triangle 200 times", 200, tree_all_same, false},
    {"seven triangles, each many times", 200, tree_copies, false},
    {"centres on a line along x", 200, tree_x_line, false},
    {"centres on a diagonal", 200, tree_diagonal, false},
    {"250 centres at powers of two", 250, tree_powers, true},
    {"62 centres at powers of two", 62, tree_few_powers, true},
    {"all in one plane", 200, tree_flat, false},
    {"bricks: along the axes, in planes", 250, tree_bricks, false},
    {"needles through everything", 100, tree_needles, false},
    {"a giant among dust", 200, tree_giant, false},
    {"coordinates at 1e6", 200, tree_far, false},
    {"coordinates at 1e-6", 200, tree_tiny, false},
    {"NaN and infinite corners", 200, tree_broken, false},
    {"triangles without area", 200, tree_no_area, false},
};

#endif
