// Wrong: gives up when the nearer point lies beyond the end: no look into the tube.
// Expect: through the open end, and from inside
// Expect: the second may still lie on the tube
#include "chapters/04-sphere/sphere.h"
#include "common/wide3.h"

real cylinder_hit(cylinder C, ray r, real t_min, real t_max) {
    const wide3 u = wide_sub(C.b, C.a), v = wide_sub(r.O, C.a), d = widen(r.d);
    const wide3 A = wide_cross(d, u), B = wide_cross(v, u);
    const double uu = wide_dot(u, u), a = wide_dot(A, A), m = wide_dot(v, A);
    const double quarter = uu * (a * C.r * C.r - m * m);
    if (!(a > 0 && C.r > 0 && quarter >= 0)) return NO_HIT;
    const double half_b = wide_dot(A, B), s = sqrt(quarter);
    const real t = nearest_root((roots){2, (-half_b - s) / a, (-half_b + s) / a}, t_min, t_max);
    if (t == NO_HIT) return NO_HIT;
    const double along = wide_dot(wide_along(v, t, d), u);
    return along >= 0 && along <= uu ? t : NO_HIT;
}
