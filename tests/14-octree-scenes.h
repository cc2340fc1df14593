// 14-octree-scenes.h: meshes and rays that make trees stumble.
#ifndef TESTS_14_OCTREE_SCENES_H
#define TESTS_14_OCTREE_SCENES_H

#include "chapters/12-bvh/shapes.h"
#include "tests/check-generic.h"

// A mesh of single triangles that is filled one by one.
typedef struct {
    vec3 *points;
    int (*corners)[3];
    int count;
} soup;

static inline soup soup_new(int room) {
    return (soup){mesh_room(3L * room + 1, sizeof(vec3)), mesh_room(room + 1L, sizeof(int[3])),
                  0};
}

static inline void soup_add(soup *s, vec3 a, vec3 b, vec3 c) {
    const int k = 3 * s->count;
    s->points[k] = a, s->points[k + 1] = b, s->points[k + 2] = c;
    for (int i = 0; i < 3; i++) s->corners[s->count][i] = k + i;
    s->count++;
}

static inline mesh soup_mesh(soup s) {
    return (mesh){.points = s.points, .corners = (const int(*)[3])s.corners, .count = s.count};
}

// Around `centre`, which is its centroid but for rounding.
static inline void soup_around(soup *s, vec3 centre, real size, rng *g) {
    const vec3 a = scale(size, in_cube(g)), b = scale(size, in_cube(g));
    soup_add(s, add(centre, a), add(centre, b), sub(centre, add(a, b)));
}

// ---- meshes ------------------------------------------------------------------------------

static inline mesh scene_none(rng *g) {
    (void)g;
    return soup_mesh(soup_new(0));
}

static inline mesh scene_clumps(int count, vec3 first, vec3 step, real size, rng *g) {
    soup s = soup_new(count);
    for (int i = 0; i < count; i++) soup_around(&s, add(first, scale((real)i, step)), size, g);
    return soup_mesh(s);
}

static inline mesh scene_one(rng *g) {
    return scene_clumps(1, in_cube(g), in_cube(g), 1, g);
}
static inline mesh scene_two(rng *g) {
    return scene_clumps(2, in_cube(g), in_cube(g), 1, g);
}
static inline mesh scene_one_centroid(rng *g) {
    return scene_clumps(200, in_cube(g), (vec3){0, 0, 0}, 1, g);
}
static inline mesh scene_line(rng *g) {
    const vec3 step = scale((real)0.01, in_cube(g));
    return scene_clumps(200, in_cube(g), step, (real)0.02, g);
}
static inline mesh scene_far(rng *g) {
    const vec3 far = scale(1000000, in_cube(g)), step = scale((real)0.5, in_cube(g));
    return scene_clumps(200, far, step, 3, g);
}

static inline mesh scene_soup(rng *g) {
    soup s = soup_new(200);
    while (s.count < 200) soup_around(&s, in_cube(g), (real)0.3, g);
    return soup_mesh(s);
}

// Centroids at 2^k in some direction: half of what is left lies beyond every midpoint.
static inline mesh scene_at_powers(int low, int high, rng *g) {
    soup s = soup_new(250);
    const vec3 direction = generic_unit(g);
    while (s.count < 250) {
        const real size = ldexp((real)1, low + s.count % (high - low));
        soup_around(&s, scale(size, direction), size / 4, g);
    }
    return soup_mesh(s);
}
static inline mesh scene_powers(rng *g) {
    return scene_at_powers(-15, 15, g);
}
// Too different for rays: from a place among the large ones even double cannot tell the corners
// of the small ones apart.
static inline mesh scene_all_powers(rng *g) {
    return scene_at_powers(-62, 62, g);
}

// Squares of a grid in a plane across an axis: all flat, most in planes that divide cells.
static inline void soup_grid(soup *s, int n, int axis, real height) {
    for (int i = 0; i < n * n; i++) {
        const real x = (real)(i % n) / n, y = (real)(i / n) / n, e = (real)1 / n;
        vec3 corner[4] = {
            {x, y, height}, {x + e, y, height}, {x + e, y + e, height}, {x, y + e, height}};
        for (int k = 0; k < 4; k++) {
            const vec3 c = corner[k];
            if (axis == 0) corner[k] = (vec3){c.z, c.x, c.y};
            if (axis == 1) corner[k] = (vec3){c.y, c.z, c.x};
        }
        soup_add(s, corner[0], corner[1], corner[2]);
        soup_add(s, corner[0], corner[2], corner[3]);
    }
}

static inline mesh scene_flat(rng *g) {
    soup s = soup_new(200);
    soup_grid(&s, 10, (int)(rng_bits(g) % 3), rng_real(g));
    return soup_mesh(s);
}

// Grids in many planes at halves, quarters and eighths: triangles in the planes that divide.
static inline mesh scene_in_planes(rng *g) {
    (void)g;
    soup s = soup_new(9 * 3 * 8);
    for (int i = 0; i <= 8; i++)
        for (int axis = 0; axis < 3; axis++) soup_grid(&s, 2, axis, (real)i / 8);
    return soup_mesh(s);
}

static inline mesh scene_giant(rng *g) {
    soup s = soup_new(201);
    soup_around(&s, in_cube(g), 1000, g);
    while (s.count < 201) soup_around(&s, in_cube(g), (real)0.01, g);
    return soup_mesh(s);
}

// The same few triangles again and again: ties everywhere.
static inline mesh scene_coincident(rng *g) {
    soup s = soup_new(150);
    while (s.count < 3) soup_around(&s, in_cube(g), 1, g);
    while (s.count < 150) {
        const int k = 3 * (int)(rng_bits(g) % 3);
        soup_add(&s, s.points[k], s.points[k + 1], s.points[k + 2]);
    }
    return soup_mesh(s);
}

static inline mesh scene_needles(rng *g) {
    soup s = soup_new(150);
    while (s.count < 150) {
        const vec3 a = in_cube(g), b = in_cube(g), c = scale((real)1e-5, in_cube(g));
        soup_add(&s, a, b, add(a, c));
    }
    return soup_mesh(s);
}

// A third without area or with corners that are not numbers.
static inline mesh scene_broken(rng *g) {
    soup s = soup_new(150);
    while (s.count < 150) {
        const vec3 a = in_cube(g), b = in_cube(g), bad = {(real)NAN, (real)INFINITY, 0};
        if (s.count % 3)
            soup_around(&s, a, (real)0.5, g);
        else
            soup_add(&s, a, b, s.count % 2 ? a : bad);
    }
    return soup_mesh(s);
}

static inline mesh scene_sponge(rng *g) {
    (void)g;
    return shape_sponge(600);
}
static inline mesh scene_stadium(rng *g) {
    (void)g;
    return shape_stadium(400);
}
static inline mesh scene_cave(rng *g) {
    (void)g;
    return shape_cave(500);
}

typedef struct {
    const char *name;
    mesh (*make)(rng *g);
    bool built_only; // no rays
} scene_row;

static const scene_row scene_rows[] = {
    {"nothing", scene_none, false},
    {"one triangle", scene_one, false},
    {"two triangles", scene_two, false},
    {"a soup", scene_soup, false},
    {"all centroids equal", scene_one_centroid, false},
    {"all centroids on a line", scene_line, false},
    {"250 centroids at powers of two", scene_powers, false},
    {"250 centroids at powers of two from 2^-62 to 2^61", scene_all_powers, true},
    {"a flat grid", scene_flat, false},
    {"triangles in the dividing planes", scene_in_planes, false},
    {"a giant among dust", scene_giant, false},
    {"the same triangles again", scene_coincident, false},
    {"coordinates at a million", scene_far, false},
    {"needles", scene_needles, false},
    {"some without area, some not finite", scene_broken, false},
    {"a sponge", scene_sponge, false},
    {"a stadium", scene_stadium, false},
    {"a cave", scene_cave, false},
};

// ---- rays --------------------------------------------------------------------------------

typedef struct {
    ray r;
    real t_min, t_max;
} probe;

static inline int random_below(rng *g, int n) {
    return n > 0 ? (int)(rng_bits(g) % (uint32_t)n) : 0;
}

// A point of a random triangle: a corner, on an edge, or within.
static inline vec3 point_of(const mesh *m, rng *g) {
    if (!m->count) return in_cube(g);
    const triangle T = mesh_triangle(m, random_below(g, m->count));
    const int kind = random_below(g, 4);
    if (kind == 0 || !is_finite(T.p3)) return T.p1;
    const vec3 on_edge = lerp(T.p1, T.p2, kind == 1 ? (real)0.5 : rng_real(g));
    return kind < 3 ? on_edge : lerp(on_edge, T.p3, rng_real(g));
}

// Some components made 0 or -0; others left.
static inline vec3 some_zero(vec3 d, rng *g) {
    const int which = random_below(g, 8);
    const real none = random_below(g, 2) ? (real)0.0 : (real)-0.0;
    return (vec3){which & 1 ? none : d.x, which & 2 ? none : d.y, which & 4 ? none : d.z};
}

// Coordinates of points of the mesh, and of its box's middle and quarters.
static inline vec3 on_planes(const mesh *m, aabb box, rng *g) {
    const vec3 a = point_of(m, g), b = point_of(m, g);
    const real s = (real)random_below(g, 5) / 4;
    const vec3 part = lerp(box.min, box.max, s);
    switch (random_below(g, 4)) {
    case 0:
        return (vec3){a.x, b.y, part.z};
    case 1:
        return (vec3){part.x, a.y, b.z};
    case 2:
        return (vec3){a.x, part.y, part.z};
    default:
        return a;
    }
}

static inline aabb finite_box(const mesh *m) {
    aabb box = {{-1, -1, -1}, {1, 1, 1}};
    for (int i = 0, first = 1; i < m->count; i++) {
        const triangle T = mesh_triangle(m, i);
        if (!is_finite(T.p1) || !is_finite(T.p2) || !is_finite(T.p3)) continue;
        box = first ? aabb_of(T) : aabb_join(box, aabb_of(T));
        first = 0;
    }
    return box;
}

// A ray towards the mesh; from outside, within, the faces of cells, or a triangle itself;
// along axes and not; with |d| from 1e-3 to 1e3; and with a short range of t now and then.
static inline probe random_probe(const mesh *m, aabb box, rng *g) {
    const vec3 size = sub(box.max, box.min);
    const vec3 aim = point_of(m, g), unit = in_cube(g);
    vec3 O = add(aabb_centre(box), mul(scale(random_below(g, 2) ? (real)0.5 : 2, unit), size));
    if (random_below(g, 3) == 0) O = on_planes(m, box, g);
    vec3 d = sub(aim, O);
    if (random_below(g, 3) == 0) d = some_zero(d, g);
    if (random_below(g, 16) == 0) d = some_zero(mul(size, unit), g);
    d = scale(random_below(g, 4) ? 1 : (real)pow(10, between(g, -3, 3)), d);
    probe p = {{O, d}, 0, NO_HIT};
    if (random_below(g, 4) == 0) p.t_min = rng_real(g);
    if (random_below(g, 4) == 0) p.t_max = p.t_min + rng_real(g);
    return p;
}

#define PROBE "ray O = " VEC ", d = " VEC ", t from %.9g to %.9g"
#define ARG_PROBE(p) ARG((p).r.O), ARG((p).r.d), (double)(p).t_min, (double)(p).t_max

#endif
