#include "chapters/04-sphere/sphere.h"
#include "common/wide3.h"

// t, when the interval holds it and the axis its point: 0 <= (v + t d)·u <= u·u.
static real accept(double t, double start, double speed, double end, real t_min, real t_max) {
    const double along = start + t * speed;
    const bool between = along >= 0 && along <= end;
    return between ? nearest_root((roots){1, t, t}, t_min, t_max) : NO_HIT;
}

// Along the axis u a tube is a circle: |(v + t d) x u|² = r² |u|².
real cylinder_hit(cylinder C, ray r, real t_min, real t_max) {
    const wide3 u = wide_sub(C.b, C.a), v = wide_sub(r.O, C.a), d = widen(r.d);
    const wide3 across_d = wide_cross(d, u), across_v = wide_cross(v, u);
    const double uu = wide_dot(u, u), rr = (double)C.r * C.r;
    const double a = wide_dot(across_d, across_d), half_b = wide_dot(across_v, across_d);
    if (!(a > 0 && C.r > 0)) return NO_HIT;
    const double m = wide_dot(v, across_d); // |m| / sqrt(a): how far the ray passes the axis
    const double quarter = uu * (a * rr - m * m);
    if (!(quarter >= 0)) return NO_HIT;
    const double c = wide_dot(across_v, across_v) - rr * uu;
    const double q = -(half_b + copysign(sqrt(quarter), half_b));
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
    const double start = wide_dot(v, u), speed = wide_dot(d, u);
    return fmin(accept(t0, start, speed, uu, t_min, t_max),
                accept(t1, start, speed, uu, t_min, t_max));
}
