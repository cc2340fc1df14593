// 05-triangle: the triangles of 01-rasterize, traced; a mesh, flat and smooth; and
// what gets through the edge between two triangles.
#include "chapters/05-triangle/triangle.h"

// ---- the triangles of 01 ---------------------------------------------------------

// The first of the equally near stays, as in the z-buffer. -1: none.
static int nearest_triangle(ray r, triangle_point *nearest) {
    int index = -1;
    nearest->t = NO_HIT;
    for (int i = 0; i < demo_triangle_count; i++) {
        const triangle_point q = triangle_hit(demo_triangles[i].t, r, 0, nearest->t);
        if (q.t == NO_HIT) continue;
        *nearest = q;
        index = i;
    }
    return index;
}

static color paint_seen(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    triangle_point q;
    const int i = nearest_triangle(r, &q);
    return i < 0 ? demo_background : demo_triangles[i].paint;
}

// The weights of p1, p2, p3 as red, green, blue.
static color weights_seen(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    triangle_point q;
    if (nearest_triangle(r, &q) < 0) return (color){0, 0, 0};
    return (color){1 - q.u - q.v, q.u, q.v};
}

// ---- meshes --------------------------------------------------------------------------

static const color gap = {(real)0.9, 0, (real)0.1}; // the inner side of a closed mesh
static const color backdrop = {(real)0.55, (real)0.7, (real)0.85};

static color lit(vec3 n) {
    const vec3 towards_lamp = {(real)0.5, (real)0.7, (real)0.5};
    const real light = (real)0.1 + (real)0.9 * fmax(dot(n, towards_lamp), 0);
    return scale(light, (color){(real)0.9, (real)0.75, (real)0.45});
}

typedef struct {
    mesh flat, smooth;
} pair;

static color shaded(const void *scene, ray r, rng *g) {
    (void)g;
    const pair *both = scene;
    int i = -1, k = -1;
    const triangle_point f = mesh_hit(&both->flat, r, 0, NO_HIT, &i);
    const triangle_point s = mesh_hit(&both->smooth, r, 0, f.t, &k);
    if (s.t != NO_HIT) return lit(mesh_surface(&both->smooth, k, r, s).n);
    if (f.t != NO_HIT) return lit(mesh_surface(&both->flat, i, r, f).n);
    return backdrop;
}

static pair two_tori(void) {
    const vec3 axis = {(real)0.35, 1, (real)0.8};
    pair both = {mesh_torus((vec3){(real)-1.45, 0, 0}, axis, 1, (real)0.42, 24, 12),
                 mesh_torus((vec3){(real)1.45, 0, 0}, axis, 1, (real)0.42, 24, 12)};
    free_normals(&both.flat);
    return both;
}
