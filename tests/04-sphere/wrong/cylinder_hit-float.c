// Wrong: in float, where the products cancel.
// Expect: Products of floats cancel here
#include "chapters/04-sphere/sphere.h"

static real accept(cylinder C, ray r, double t, real t_min, real t_max) {
    const vec3 axis = sub(C.b, C.a);
    const real along = dot(sub(ray_at(r, (real)t), C.a), axis);
    const bool between = along >= 0 && along <= dot(axis, axis);
    return between ? nearest_root((roots){1, t, t}, t_min, t_max) : NO_HIT;
}

real cylinder_hit(cylinder C, ray r, real t_min, real t_max) {
    if (!(C.r > 0) || dot(sub(C.b, C.a), sub(C.b, C.a)) == 0) return NO_HIT;
    const vec3 axis = normalize(sub(C.b, C.a)), v = sub(r.O, C.a);
    const vec3 v_flat = sub(v, scale(dot(v, axis), axis));
    const vec3 d_flat = sub(r.d, scale(dot(r.d, axis), axis));
    const real c = dot(v_flat, v_flat) - C.r * C.r;
    const roots q = solve_quadratic(dot(d_flat, d_flat), 2 * dot(v_flat, d_flat), c);
    if (q.count < 2) return NO_HIT;
    return fmin(accept(C, r, q.t0, t_min, t_max), accept(C, r, q.t1, t_min, t_max));
}
