// Right: complex arithmetic: the formulas for glass with a complex index.
#include "chapters/11-fresnel/fresnel.h"

#include <complex.h>

static real reflectance(double c, double eta, double k) {
    const double complex N = eta + k * I, w = csqrt(N * N - (1 - c) * (1 + c));
    const double s = cabs((c - w) / (c + w)), p = cabs((N * N * c - w) / (N * N * c + w));
    return (real)((s * s + p * p) / 2);
}

color fresnel_conductor(real cosine, color eta, color k) {
    return (color){reflectance(cosine, eta.x, k.x), reflectance(cosine, eta.y, k.y),
                   reflectance(cosine, eta.z, k.z)};
}
