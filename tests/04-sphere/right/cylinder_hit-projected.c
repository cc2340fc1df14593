// Right: by projection onto the plane perpendicular to the axis, with stable_quadratic.
#include "chapters/04-sphere/sphere.h"
#include "common/wide3.h"

real cylinder_hit(cylinder C, ray r, real t_min, real t_max) {
    const wide3 u = wide_sub(C.b, C.a), v = wide_sub(r.O, C.a), d = widen(r.d);
    const double uu = wide_dot(u, u);
    if (!(uu > 0 && C.r > 0)) return NO_HIT;
    const wide3 cross_d = wide_cross(d, u);
    if (wide_dot(cross_d, cross_d) == 0) return NO_HIT; // parallel
    const wide3 v_flat = wide_along(v, -wide_dot(v, u) / uu, u);
    const wide3 d_flat = wide_along(d, -wide_dot(d, u) / uu, u);
    const double c = wide_dot(v_flat, v_flat) - (double)C.r * C.r;
    const roots q = stable_quadratic(wide_dot(d_flat, d_flat), 2 * wide_dot(v_flat, d_flat), c);
    real nearest = NO_HIT;
    for (int i = 2 - q.count; i < 2; i++) {
        const double t = i ? q.t0 : q.t1;
        const double along = wide_dot(v, u) + t * wide_dot(d, u);
        const real accepted = nearest_root((roots){1, t, t}, t_min, t_max);
        if (along >= 0 && along <= uu && accepted < nearest) nearest = accepted;
    }
    return nearest;
}
