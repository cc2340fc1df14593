// variants.h: the ways to meet a sphere that measure.c compares. All treat a tangent, r = 0
// and d = 0 as sphere_hit does.
#ifndef CHAPTER_SPHERE_VARIANTS_H
#define CHAPTER_SPHERE_VARIANTS_H

#include "chapters/04-sphere/sphere.h"
#include "common/wide3.h"

// ---- in real arithmetic ----------------------------------------------------------

// The slide's formula with b = 2 half_b put in and the twos cancelled.
static real b_half(sphere S, ray r, real t_min, real t_max) {
    const vec3 v = sub(r.O, S.c);
    const real a = dot(r.d, r.d), half_b = dot(v, r.d), c = dot(v, v) - S.r * S.r;
    const real quarter = half_b * half_b - a * c;
    if (!(quarter >= 0 && a > 0 && S.r > 0)) return NO_HIT;
    const real s = sqrt(quarter);
    return nearest_root((roots){2, (-half_b - s) / a, (-half_b + s) / a}, t_min, t_max);
}

// The roots q / a and c / q, from a quarter of the discriminant.
static real by_q(sphere S, ray r, real quarter, real t_min, real t_max) {
    const vec3 v = sub(r.O, S.c);
    const real a = dot(r.d, r.d), half_b = dot(v, r.d), c = dot(v, v) - S.r * S.r;
    if (!(quarter >= 0 && a > 0 && S.r > 0)) return NO_HIT;
    const real q = -(half_b + copysign(sqrt(quarter), half_b));
    const real t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return nearest_root((roots){2, fmin(t0, t1), fmax(t0, t1)}, t_min, t_max);
}

static real plus_q(sphere S, ray r, real t_min, real t_max) {
    const vec3 v = sub(r.O, S.c);
    const real a = dot(r.d, r.d), half_b = dot(v, r.d), c = dot(v, v) - S.r * S.r;
    return by_q(S, r, half_b * half_b - a * c, t_min, t_max);
}

// Hearn and Baker, Computer Graphics with OpenGL: a unit direction, and what is left
// of v perpendicular to it.
static real hearn_baker(sphere S, ray r, real t_min, real t_max) {
    const vec3 v = sub(r.O, S.c);
    const real speed = length(r.d);
    const vec3 unit = scale(1 / speed, r.d);
    const real along = dot(v, unit);
    const vec3 l = sub(v, scale(along, unit));
    const real square = S.r * S.r - dot(l, l);
    if (!(square >= 0 && S.r > 0)) return NO_HIT;
    const real s = sqrt(square);
    return nearest_root((roots){2, (-along - s) / speed, (-along + s) / speed}, t_min, t_max);
}

// Ray Tracing Gems, ch. 7 (Haines, Günther, Akenine-Möller 2019): that, and q.
static real gems(sphere S, ray r, real t_min, real t_max) {
    return by_q(S, r, far_discriminant(S, r), t_min, t_max);
}

// The same number by Lagrange's identity: a |v|² - (v·d)² = |v x d|².
static real crossed(sphere S, ray r, real t_min, real t_max) {
    const vec3 w = cross(sub(r.O, S.c), r.d);
    return by_q(S, r, dot(r.d, r.d) * S.r * S.r - dot(w, w), t_min, t_max);
}

// PBRT 4th ed., section 6.8, without its intervals: r² - l² as a product.
static real pbrt(sphere S, ray r, real t_min, real t_max) {
    const vec3 v = sub(r.O, S.c);
    const real a = dot(r.d, r.d);
    const real l = length(sub(v, scale(dot(v, r.d) / a, r.d)));
    return by_q(S, r, a * (S.r + l) * (S.r - l), t_min, t_max);
}

// ---- mixed: real in, double inside, real out ----------------------------------------

static real double_inside(sphere S, ray r, real t_min, real t_max) {
    const wide3 v = wide_sub(r.O, S.c), d = widen(r.d);
    const double a = wide_dot(d, d), b = 2 * wide_dot(v, d);
    const double c = wide_dot(v, v) - (double)S.r * S.r;
    const double discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0 && a > 0 && S.r > 0)) return NO_HIT;
    const double s = sqrt(discriminant);
    return nearest_root((roots){2, (-b - s) / (2 * a), (-b + s) / (2 * a)}, t_min, t_max);
}

static real double_q(sphere S, ray r, real t_min, real t_max) {
    const wide3 v = wide_sub(r.O, S.c), d = widen(r.d);
    const double a = wide_dot(d, d), half_b = wide_dot(v, d);
    const double c = wide_dot(v, v) - (double)S.r * S.r;
    const double quarter = half_b * half_b - a * c;
    if (!(quarter >= 0 && a > 0 && S.r > 0)) return NO_HIT;
    const double q = -(half_b + copysign(sqrt(quarter), half_b));
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return nearest_root((roots){2, fmin(t0, t1), fmax(t0, t1)}, t_min, t_max);
}

static real double_gems(sphere S, ray r, real t_min, real t_max) {
    const wide3 v = wide_sub(r.O, S.c), d = widen(r.d);
    const double a = wide_dot(d, d), half_b = wide_dot(v, d), rr = (double)S.r * S.r;
    const wide3 l = wide_along(v, -half_b / a, d);
    const double quarter = a * (rr - wide_dot(l, l));
    if (!(quarter >= 0 && a > 0 && S.r > 0)) return NO_HIT;
    const double q = -(half_b + copysign(sqrt(quarter), half_b)), c = wide_dot(v, v) - rr;
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return nearest_root((roots){2, fmin(t0, t1), fmax(t0, t1)}, t_min, t_max);
}

#endif
