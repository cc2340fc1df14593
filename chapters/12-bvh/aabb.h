// aabb.h: boxes with sides along the axes, and what of a ray is in one.
#ifndef CHAPTER_AABB_H
#define CHAPTER_AABB_H

#include "chapters/05-triangle/triangle.h"

// All points with min <= p <= max, faces included. A flat box, min = max along an axis, is
// one too; with min > max it is empty.
typedef struct {
    vec3 min, max;
} aabb;

static const aabb aabb_empty = {{INFINITY, INFINITY, INFINITY},
                                {-INFINITY, -INFINITY, -INFINITY}};

static inline real lesser(real a, real b) {
    return a < b ? a : b;
}
static inline real greater(real a, real b) {
    return a > b ? a : b;
}

// The smallest box that holds both.
static inline aabb aabb_join(aabb a, aabb b) {
    return (aabb){
        {lesser(a.min.x, b.min.x), lesser(a.min.y, b.min.y), lesser(a.min.z, b.min.z)},
        {greater(a.max.x, b.max.x), greater(a.max.y, b.max.y), greater(a.max.z, b.max.z)}};
}

static inline aabb aabb_with(aabb a, vec3 p) {
    return aabb_join(a, (aabb){p, p});
}

static inline aabb aabb_of(triangle T) {
    return aabb_with(aabb_with((aabb){T.p1, T.p1}, T.p2), T.p3);
}

// The surface area of the slide's A_l and A_r; 0 for an empty box.
static inline real aabb_area(aabb a) {
    const vec3 e = sub(a.max, a.min);
    return e.x < 0 ? 0 : 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

static inline vec3 aabb_centre(aabb a) {
    return scale((real)0.5, add(a.min, a.max));
}

// The component of v along an axis: 0, 1, 2 are x, y, z.
static inline real along(vec3 v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// A ray with what it asks of every box, worked out once. With s one of a box's six numbers, the
// ray is there at t = (s - O) / d: s * near_scale + near_offset is never more than that,
// s * far_scale + far_offset never less, and both only by a few roundings of s and O.
typedef struct {
    vec3 O, d;
    vec3 inverse; // 1 / d; infinite where d is 0, with its sign
    vec3 near_scale, near_offset, far_scale, far_offset;
    size_t near[3], far[3]; // which of a box's six numbers, min.x min.y min.z max.x max.y max.z,
                            // the ray meets first and last along x, y, z
} slab_ray;

slab_ray slab_ray_of(ray r);

// a b + c, in one instruction where there is one.
static inline real times_plus(real a, real b, real c) {
#if defined FP_FAST_FMA && defined FP_FAST_FMAF
    return fma(a, b, c);
#else
    return a * b + c;
#endif
}

// Exercise: exercises/12-bvh/aabb_hit.c
// Does the ray meet the box at any t in [t_min, t_max], 0 <= t_min? Then *enter is where, at
// least t_min. Never misses what an exact test would hit, also in a face, along an edge, with
// d = ±0 and in flat boxes: it may hit boxes that the ray passes within a few roundings.
// t_max may be INFINITY. False for an empty box. Sources: Williams et al. 2005; Ize 2013.
bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter);

#endif
