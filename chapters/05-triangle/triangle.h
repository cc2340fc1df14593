// triangle.h: where a ray meets a triangle, and a small mesh.
#ifndef CHAPTER_TRIANGLE_H
#define CHAPTER_TRIANGLE_H

#include "chapters/01-rasterize/rasterize.h"
#include "chapters/04-sphere/sphere.h"

// p = (1 - u - v) p1 + u p2 + v p3, u, v >= 0, u + v <= 1. t = NO_HIT: missed.
typedef struct {
    real t, u, v;
} triangle_point;

// (p2 - p1) x (p3 - p1): twice the area long, outward by orientation. Double
// inside.
vec3 triangle_normal(triangle T);

// Is that normal, in double and not rounded further, other than (0, 0, 0)? Never
// for corners that coincide; nor for corners on one line, as long as double
// holds the differences of their coordinates without rounding.
bool triangle_has_area(triangle T);

// The lecture's first method: the plane, then the inside test, in real
// arithmetic. Leaks between triangles (the chapter measures how much).
triangle_point triangle_hit_slide(triangle T, ray r, real t_min, real t_max);

// The nearest hit with t_min < t < t_max, where t is rounded to real before it is
// compared. Edges and corners belong to the triangle; zero area is never hit, nor
// is a NaN; both sides are. The variant that the chapter's measurements justify:
// watertight_hit.
triangle_point triangle_hit(triangle T, ray r, real t_min, real t_max);

hit triangle_surface(triangle T, ray r, triangle_point q);

// Another way to search a mesh than one triangle after the other (chapters 12 to 14). Its
// functions keep the contracts of mesh_hit and mesh_any.
typedef struct {
    const void *tree; // what is passed to them
    triangle_point (*nearest)(const void *tree, ray r, real t_min, real t_max, int *index);
    bool (*any)(const void *tree, ray r, real t_min, real t_max);
} finder;

// Triangles that share their corners.
typedef struct {
    const vec3 *points;
    const vec3 *normals;     // one a point, unit; or NULL: flat
    const int (*corners)[3]; // indices of points
    int count;               // of triangles
    sphere around;           // holds all points: what misses it misses all; r = 0: unknown
    const finder *finder;    // NULL: one triangle after the other
} mesh;

static inline triangle mesh_triangle(const mesh *m, int i) {
    const int *k = m->corners[i];
    return (triangle){m->points[k[0]], m->points[k[1]], m->points[k[2]]};
}

// The nearest hit of all triangles; *index is the triangle's, untouched on a miss. Of two
// equally near the one with the smaller index.
triangle_point mesh_hit(const mesh *m, ray r, real t_min, real t_max, int *index);

// Is there any hit with t_min < t < t_max?
bool mesh_any(const mesh *m, ray r, real t_min, real t_max);

// The hit of triangle `index`, its normal smooth where the mesh has normals.
hit mesh_surface(const mesh *m, int index, ray r, triangle_point q);

// A torus, closed: a tube of radius `tube` around a circle of radius `ring` in
// the plane through `centre` perpendicular to `axis` (any length but 0), of
// around x across points and 2 around across triangles; around, across >= 3.
// Free it with mesh_free.
mesh mesh_torus(vec3 centre, vec3 axis, real ring, real tube, int around, int across);
void mesh_free(mesh *m);

// Zeroed memory for count > 0 parts of a mesh; dies when there is none. mesh_free frees it.
void *mesh_room(long count, size_t size);

// Exercises: exercises/05-triangle/ ----------------------------------------

// The inside test of the first method: p lies in the plane of T, whose normal
// is n = triangle_normal(T), not 0. Is it in the triangle? Edges and corners are.
bool point_in_triangle(vec3 p, triangle T, vec3 n);

// t, u, v at once, by Cramer's rule. Source: Möller and Trumbore 1997. Double
// inside; a determinant of exactly 0 misses; the rest as triangle_hit.
triangle_point moller_trumbore(triangle T, ray r, real t_min, real t_max);

// The watertight test: no ray passes between two triangles that share an edge
// or a corner. Source: Woop, Benthin and Wald 2013. Double inside; the rest as
// triangle_hit.
triangle_point watertight_hit(triangle T, ray r, real t_min, real t_max);

// The unit normal at (u, v), interpolated between the unit normals of the
// corners; when they cancel, the normal n1.
vec3 smooth_normal(vec3 n1, vec3 n2, vec3 n3, real u, real v);

#endif
