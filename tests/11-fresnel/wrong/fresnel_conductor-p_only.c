// Wrong: r_p² alone.
// Expect: r_p² alone: unpolarised light is half r_s², half r_p²
#include "chapters/11-fresnel/fresnel.h"

static real reflectance(double c, double eta, double k) {
    const double sin2 = 1 - c * c, re = eta * eta - k * k - sin2;
    const double size = sqrt(re * re + 4 * eta * eta * k * k);
    const double a = sqrt(fmax((size + re) / 2, 0)), u = size + c * c, v = 2 * a * c;
    const double Rs = (u - v) / (u + v);
    const double p = c * c * size + sin2 * sin2, q = v * sin2;
    const double Rp = Rs * (p - q) / (p + q);
    return (real)(Rp);
}

color fresnel_conductor(real cosine, color eta, color k) {
    return (color){reflectance(cosine, eta.x, k.x), reflectance(cosine, eta.y, k.y),
                   reflectance(cosine, eta.z, k.z)};
}
