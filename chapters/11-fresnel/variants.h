// variants.h: the same formulas in other ways and in other precision, for measure.c.
#ifndef CHAPTER_FRESNEL_VARIANTS_H
#define CHAPTER_FRESNEL_VARIANTS_H

#include "chapters/11-fresnel/fresnel.h"
#include "common/exact3.h"

// ---- the reflectance --------------------------------------------------------------------------

static exact exact_fresnel(real cosine, real eta) {
    const exact c = cosine, e = eta, g2 = (e - 1) * (e + 1) + c * c;
    if (e == 1) return 0;
    if (g2 <= 0) return 1;
    const exact g = exact_sqrt(g2);
    const exact rs = (c - g) / (c + g), rp = (e * e * c - g) / (e * e * c + g);
    return (rs * rs + rp * rp) / 2;
}

typedef real formula(real cosine, real eta);

// r_s and r_p by Snell's law, as in a textbook; NaN on total reflection unless it is caught.
static real textbook(real cosine, real eta) {
    const real sine = sqrt(1 - cosine * cosine) / eta;
    if (sine >= 1) return 1;
    const real t = sqrt(1 - sine * sine);
    const real rs = (cosine - eta * t) / (cosine + eta * t);
    const real rp = (eta * cosine - t) / (eta * cosine + t);
    return (rs * rs + rp * rp) / 2;
}

// fresnel_dielectric's formula, in real arithmetic throughout.
static real factored(real cosine, real eta) {
    const real c = cosine, m = (eta - 1) * (eta + 1), g2 = m + c * c;
    if (m == 0) return 0;
    if (g2 <= 0) return 1;
    const real g = sqrt(g2), sin2 = (1 - c) * (1 + c);
    const real rs = m / ((c + g) * (c + g)), q = (c * g - sin2) / (c * g + sin2);
    return rs * rs * (1 + q * q) / 2;
}

static real schlick_pow(real cosine, real eta) {
    const real r = (eta - 1) / (eta + 1);
    return r * r + (1 - r * r) * pow(1 - cosine, (real)5);
}

// ---- Snell's law ---------------------------------------------------------------------------

// cos² of the far side; below 0: total reflection.
typedef real far_side(real cosine, real eta);

static real by_sine(real cosine, real eta) {
    const real sine = sqrt(1 - cosine * cosine) / eta;
    return 1 - sine * sine;
}

static real by_squares(real cosine, real eta) {
    return 1 - (1 - cosine * cosine) / (eta * eta);
}

static real by_product(real cosine, real eta) {
    return 1 - (1 - cosine) * (1 + cosine) / (eta * eta);
}

static real by_sum(real cosine, real eta) { // as refract, in real
    return ((eta - 1) * (eta + 1) + cosine * cosine) / (eta * eta);
}

static real by_sum_wide(real cosine, real eta) { // as refract
    const double e = (double)eta, c = (double)cosine;
    return (real)(((e - 1) * (e + 1) + c * c) / (e * e));
}

#endif
