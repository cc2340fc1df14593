#include "chapters/04-sphere/sphere.h"

// t when it lies in the interval and its point between the ends of the axis.
static real accept(cylinder C, ray r, double t, real t_min, real t_max) {
    const vec3 axis = sub(C.b, C.a);
    const real along = dot(sub(ray_at(r, (real)t), C.a), axis);
    const bool between = along >= 0 && along <= dot(axis, axis);
    return between && t > t_min && t < t_max ? (real)t : NO_HIT;
}

real cylinder_hit(cylinder C, ray r, real t_min, real t_max) {
    const vec3 axis = normalize(sub(C.b, C.a));
    const vec3 v = sub(r.O, C.a);
    // What is perpendicular to the axis is the picture of a circle, and of a line.
    const vec3 v_flat = sub(v, scale(dot(v, axis), axis));
    const vec3 d_flat = sub(r.d, scale(dot(r.d, axis), axis));
    const real a = dot(d_flat, d_flat);
    if (!(a > 0 && C.r > 0)) return NO_HIT;
    const roots q =
        solve_quadratic(a, 2 * dot(v_flat, d_flat), dot(v_flat, v_flat) - C.r * C.r);
    if (q.count == 0) return NO_HIT;
    return fmin(accept(C, r, q.t0, t_min, t_max), accept(C, r, q.t1, t_min, t_max));
}
