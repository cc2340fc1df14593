#include "chapters/11-fresnel/fresnel.h"

// (a + i b)² = (eta + i k)² - sin²; then R_s and R_p as for a dielectric with the complex
// cosine.
static real reflectance(double c, double eta, double k) {
    const double sin2 = (1 - c) * (1 + c), re = eta * eta - k * k - sin2;
    const double a2b2 = sqrt(re * re + 4 * eta * eta * k * k);
    const double a = sqrt(fmax((a2b2 + re) / 2, 0));
    const double u = a2b2 + c * c, v = 2 * a * c;
    const double Rs = (u - v) / (u + v);
    const double p = c * c * a2b2 + sin2 * sin2, q = v * sin2;
    return (real)(Rs * (1 + (p - q) / (p + q)) / 2);
}

color fresnel_conductor(real cosine, color eta, color k) {
    const double c = cosine;
    return (color){reflectance(c, eta.x, k.x), reflectance(c, eta.y, k.y),
                   reflectance(c, eta.z, k.z)};
}
