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

// The slide's a and c and half its b, in double, but not its b² - 4ac: by Lagrange's identity
// a |v|² - (v·d)² = |v x d|², so a quarter of the discriminant is a r² - |v x d|².
real sphere_hit(sphere S, ray r, real t_min, real t_max) {
    const wide3 v = wide_sub(r.O, S.c), d = widen(r.d), w = wide_cross(v, d);
    const double a = wide_dot(d, d), rr = (double)S.r * S.r;
    const double quarter = a * rr - wide_dot(w, w);
    if (!(quarter >= 0 && a > 0 && S.r > 0)) return NO_HIT; // false for NaN
    const double half_b = wide_dot(v, d), c = wide_dot(v, v) - rr;
    const double q = -(half_b + copysign(sqrt(quarter), half_b));
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return nearest_root((roots){2, t0 < t1 ? t0 : t1, t0 < t1 ? t1 : t0}, t_min, t_max);
}

// The normal where the ray meets the sphere at t. t only says which end of the chord: it is
// rounded, and far away that may be a whole radius.
static wide3 normal_at(sphere S, ray r, real t) {
    const wide3 v = wide_sub(r.O, S.c), d = widen(r.d);
    const double per_a = 1 / wide_dot(d, d), middle = -wide_dot(v, d) * per_a;
    const wide3 l = wide_along(v, middle, d); // to the ray's point nearest the centre
    const double square = (double)S.r * S.r - wide_dot(l, l),
                 half = square > 0 ? sqrt(square * per_a) : 0;
    const wide3 end = wide_along(l, t <= (real)middle ? -half : half, d);
    const double k = 1 / sqrt(wide_dot(end, end));
    return (wide3){k * end.x, k * end.y, k * end.z};
}

hit sphere_surface(sphere S, ray r, real t) {
    const wide3 n = normal_at(S, r, t), c = widen(S.c);
    hit h = hit_at(r, t, narrow(n));
    h.p = narrow(wide_along(c, S.r, n));
    // The rounding of p, and those of the double arithmetic before it.
    const vec3 summed = add(absolute(S.c), scale(S.r, absolute(h.n)));
    h.error =
        add(scale(rounding_bound(2), absolute(h.p)), scale((real)(4 * DBL_EPSILON), summed));
    return h;
}
