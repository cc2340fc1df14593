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

static inline vec3 aabb_centre(aabb a) { // halved first: the sum might overflow
    return add(scale((real)0.5, a.min), scale((real)0.5, a.max));
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
    real near_scale[3], near_offset[3], far_scale[3], far_offset[3];
    // Which of a box's six numbers, min.x min.y min.z max.x max.y max.z, the ray meets first
    // and last along x, y, z.
    size_t near[3], far[3];
} slab_ray;

static inline vec3 reciprocal(vec3 d) {
    return (vec3){1 / d.x, 1 / d.y, 1 / d.z};
}

static inline real longest_of(vec3 d) {
    const vec3 a = absolute(d);
    return greater(a.x, greater(a.y, a.z));
}

static inline real not_zero(real d, real least) {
    return d == 0 ? copysign(least, d) : d;
}

// O moved along d, by what rounding may make of O and of products with it; where O is 0, by a
// length that is nothing in any scene.
static inline vec3 shifted(vec3 O, vec3 d) {
    const real least = (real)1e-12, share = 2 * rounding_bound(4);
    return (vec3){O.x + copysign(least + share * fabs(O.x), d.x),
                  O.y + copysign(least + share * fabs(O.y), d.y),
                  O.z + copysign(least + share * fabs(O.z), d.z)};
}

// t = s / d - O / d is infinity less infinity where d is 0. There d is taken as 2^-80 of
// its longest component: a ray along a face of a box then stays in it for a length of 1e-12
// 2^80, 1e12. A scale has two roundings, its product with s and the sum two more.
static inline slab_ray slab_ray_of(ray r) {
    const size_t x = signbit(r.d.x) ? 3 : 0, y = signbit(r.d.y) ? 3 : 0,
                 z = signbit(r.d.z) ? 3 : 0;
    const real least = (real)0x1p-80 * longest_of(r.d);
    const vec3 inverse = reciprocal(
        (vec3){not_zero(r.d.x, least), not_zero(r.d.y, least), not_zero(r.d.z, least)});
    const vec3 early = scale(1 - 2 * rounding_bound(4), inverse),
               late = scale(1 + 2 * rounding_bound(4), inverse);
    const vec3 start = mul(shifted(r.O, r.d), early), end = mul(shifted(r.O, neg(r.d)), late);
    return (slab_ray){.O = r.O,
                      .d = r.d,
                      .inverse = reciprocal(r.d),
                      .near_scale = {early.x, early.y, early.z},
                      .near_offset = {-start.x, -start.y, -start.z},
                      .far_scale = {late.x, late.y, late.z},
                      .far_offset = {-end.x, -end.y, -end.z},
                      .near = {x, 1 + y, 2 + z},
                      .far = {3 - x, 4 - y, 5 - z}};
}

// a b + c, in one instruction where there is one.
static inline real times_plus(real a, real b, real c) {
#if defined FP_FAST_FMA && defined FP_FAST_FMAF
    return fma(a, b, c);
#else
    return a * b + c;
#endif
}

// Exercise: exercises/12-bvh/aabb_hit.c
// Does the ray meet the box at any t in [t_min, t_max], 0 <= t_min? Then *enter is where it comes
// in, t_min if it is in the box already then, or earlier by a few roundings of t, O and the box: never beyond a hit in the box. Never
// misses what an exact test would hit, also in a face (for a length of 1e12), along an edge, with
// d = ±0, in flat boxes and at t_max; it may hit boxes that the ray passes within those roundings.
// t_max may be INFINITY. False for an empty box. Coordinates, |d| and t that are not 0 must lie well
// within real's range, 1e-18 to 1e18 in float. Sources: Williams et al. 2005; Ize 2013.
bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter);

#endif
