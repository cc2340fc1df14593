// check-trees.h: meshes that are hard on a tree, rays that are hard on a walk, and whether a
// searcher finds what brute force finds, bit for bit.
#ifndef TESTS_CHECK_TREES_H
#define TESTS_CHECK_TREES_H

#include <string.h>

#include "chapters/12-bvh/shapes.h"
#include "chapters/13-kd-tree/searcher.h"
#include "tests/check-generic.h"
#include "tests/check.h"

// ---- meshes --------------------------------------------------------------------------------

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

typedef struct {
    const searcher *by;
    const char *nearest, *any; // how they are called: for the messages
    const char *scene;
    const mesh *m; // without a finder
    const void *tree;
} tree_case;

// What was asked, also when it crashes.
static inline void given_ray(const tree_case *c, ray r, real t_min, real t_max) {
    given("%s: %d triangles%s\nray O = " VEC ", d = " VEC "\nt_min = %.9g, t_max = %.9g; "
          "spent = NULL",
          c->scene, c->m->count, c->m->count ? "" : ": no node, and no array of nodes",
          ARG(r.O), ARG(r.d), (double)t_min, (double)t_max);
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
           "begin beyond found.limit is asked, whatever the top of the stack says.";
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
    hint_instead(tree_hint(c->m, r, q.t, want.t, got, -1));
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

static inline void tree_agrees_on_scenes(const searcher *by, const char *nearest,
                                         const char *any, int rays, rng *g) {
    for (int i = 0; i < COUNT(tree_scenes); i++) {
        mesh m = tree_soup(tree_scenes[i].count, tree_scenes[i].make, g);
        void *tree = by->build(&m);
        const tree_case c = {by, nearest, any, tree_scenes[i].name, &m, tree};
        if (tree_scenes[i].from_origin) tree_agrees_from_origin(&c, rays, g);
        for (int aim = 0; aim < TREE_AIMS && !tree_scenes[i].from_origin; aim++)
            tree_agrees_on_aim(&c, (tree_aim)aim, rays, g);
        by->free(tree);
        mesh_free(&m);
    }
}

static inline void tree_agrees_on_shapes(const searcher *by, const char *nearest,
                                         const char *any, int rays, rng *g) {
    for (const shape *s = shapes; s->name; s++) {
        mesh m = s->make(500);
        void *tree = by->build(&m);
        const tree_case c = {by, nearest, any, s->name, &m, tree};
        for (int aim = 0; aim < TREE_AIMS; aim++)
            tree_agrees_on_aim(&c, (tree_aim)aim, rays, g);
        by->free(tree);
        mesh_free(&m);
    }
}

// Few triangles, many rays, many trees.
static inline void tree_agrees_on_many(const searcher *by, const char *nearest, const char *any,
                                       int trees, int rays, rng *g) {
    for (int i = 0; i < trees; i++) {
        mesh m = tree_soup(2 + tree_whole(g, 11), tree_cloud, g);
        void *tree = by->build(&m);
        const tree_case c = {by, nearest, any, "a few triangles", &m, tree};
        tree_agrees_on_aim(&c, AT_ANYTHING, rays, g);
        by->free(tree);
        mesh_free(&m);
    }
}

#endif
