#include "chapters/11-fresnel/fresnel.h"

// a + i b = sqrt((eta + i k)² - sin²) takes the place of eta cos θ_t. Its square has the
// real part re and the imaginary part 2 a b = 2 eta k. The larger of a and b is the sum
// that does not cancel; the other follows from a b.
static double reflectance(double c, double eta, double k) {
    const double sin2 = (1 - c) * (1 + c), re = (eta - 1) * (eta + 1) - k * k + c * c;
    const double im = 2 * eta * k, a2b2 = sqrt(re * re + im * im); // a² + b²
    const double larger = sqrt((a2b2 + fabs(re)) / 2);
    const double a = re > 0 ? larger : larger > 0 ? eta * k / larger : 0;
    const double u = a2b2 + c * c, v = 2 * a * c;              // R_s = (u - v) / (u + v)
    const double p = a2b2 * c * c + sin2 * sin2, q = v * sin2; // R_p = R_s (p - q) / (p + q)
    return (u - v) * p / ((u + v) * (p + q));                  // the mean of both
}

color fresnel_conductor(real cosine, color eta, color k) {
    return (color){(real)reflectance(cosine, eta.x, k.x), (real)reflectance(cosine, eta.y, k.y),
                   (real)reflectance(cosine, eta.z, k.z)};
}
