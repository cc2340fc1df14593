// sphere.c: see sphere.h. The derivations are in README.md.
#include "chapters/04-sphere/sphere.h"

#include "common/wide3.h"

roots solve_quadratic(double a, double b, double c) {
    if (a == 0) {
        if (b == 0) return (roots){0, 0, 0};
        return (roots){1, -c / b, -c / b};
    }
    const double discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return (roots){0, 0, 0};
    const double s = sqrt(discriminant);
    const double t0 = (-b - s) / (2 * a), t1 = (-b + s) / (2 * a);
    return (roots){2, fmin(t0, t1), fmax(t0, t1)};
}

real sphere_hit_slide(sphere S, ray r, real t_min, real t_max) {
    const vec3 v = sub(r.O, S.c);
    const real a = dot(r.d, r.d);
    const real b = 2 * dot(v, r.d);
    const real c = dot(v, v) - S.r * S.r;
    const real discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0 && a > 0 && S.r > 0)) return NO_HIT;
    const real s = sqrt(discriminant);
    return nearest_root((roots){2, (-b - s) / (2 * a), (-b + s) / (2 * a)}, t_min, t_max);
}

// The remainder form, in double: the discriminant from the part of v that is
// perpendicular to d, which does not cancel however far away the sphere is.
real sphere_hit(sphere S, ray r, real t_min, real t_max) {
    const wide3 d = widen(r.d), v = wide_sub(r.O, S.c);
    const double a = wide_dot(d, d), half_b = wide_dot(v, d), radius = S.r;
    if (!(a > 0 && radius > 0)) return NO_HIT;
    const wide3 l = wide_along(v, -half_b / a, d);
    const double quarter = radius * radius - wide_dot(l, l); // discriminant / 4a
    if (!(quarter >= 0)) return NO_HIT;
    const double q = -(half_b + copysign(sqrt(a * quarter), half_b));
    const double c = wide_dot(v, v) - radius * radius;
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return nearest_root((roots){2, fmin(t0, t1), fmax(t0, t1)}, t_min, t_max);
}

hit sphere_surface(sphere S, ray r, real t) {
    const vec3 n = normalize(sub(ray_at(r, t), S.c));
    hit h = hit_at(r, t, n);
    // Back onto the sphere: then the error no longer grows with the distance from O.
    const vec3 out = scale(S.r, n);
    h.p = add(S.c, out);
    h.error = scale(rounding_bound(5), add(absolute(S.c), absolute(out)));
    return h;
}
