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

// The part of the ray inside the sphere, seen from its middle. All of it is NaN for d = 0.
typedef struct {
    wide3 d, v;
    double a, half_b;
    double middle; // t of the ray's point nearest to the centre
    wide3 l;       // from the centre to that point, perpendicular to d
    double square; // of half the chord's length; negative: the ray passes outside
} chord;

static chord chord_of(sphere S, ray r) {
    chord k = {.d = widen(r.d), .v = wide_sub(r.O, S.c)};
    k.a = wide_dot(k.d, k.d);
    k.half_b = wide_dot(k.v, k.d);
    k.middle = -k.half_b / k.a;
    k.l = wide_along(k.v, k.middle, k.d);
    k.square = (double)S.r * S.r - wide_dot(k.l, k.l);
    return k;
}

real sphere_hit(sphere S, ray r, real t_min, real t_max) {
    const chord k = chord_of(S, r);
    if (!(S.r > 0 && k.square >= 0)) return NO_HIT; // false for NaN
    const double c = wide_dot(k.v, k.v) - (double)S.r * S.r;
    const double q = -(k.half_b + copysign(sqrt(k.a * k.square), k.half_b));
    const double t0 = q / k.a, t1 = q == 0 ? t0 : c / q;
    return nearest_root((roots){2, fmin(t0, t1), fmax(t0, t1)}, t_min, t_max);
}

// From the centre to the hit at t, of length r. t only says which end of the chord: rounded,
// it may lie a whole radius off, far away.
static wide3 chord_end(sphere S, ray r, real t) {
    const chord k = chord_of(S, r);
    const double half = sqrt(fmax(k.square, 0) / k.a);
    const wide3 end = wide_along(k.l, t <= (real)k.middle ? -half : half, k.d);
    const double stretch = S.r / sqrt(wide_dot(end, end));
    return (wide3){stretch * end.x, stretch * end.y, stretch * end.z};
}

hit sphere_surface(sphere S, ray r, real t) {
    const wide3 out = chord_end(S, r, t), c = widen(S.c);
    hit h = hit_at(r, t, narrow((wide3){out.x / S.r, out.y / S.r, out.z / S.r}));
    h.p = narrow(wide_along(c, 1, out));
    // The rounding of p, and those of the double arithmetic before it.
    h.error = add(scale(rounding_bound(2), absolute(h.p)),
                  scale((real)(4 * DBL_EPSILON), add(absolute(S.c), absolute(narrow(out)))));
    return h;
}
