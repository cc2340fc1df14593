// Wrong: the approximation for a large index, without the sine.
// Expect: the approximation for a large index, without the sine
#include "chapters/11-fresnel/fresnel.h"

static real reflectance(double c, double eta, double k) {
    const double size = eta * eta + k * k, v = 2 * eta * c;
    const double Rs = (size - v + c * c) / (size + v + c * c);
    const double Rp = (size * c * c - v + 1) / (size * c * c + v + 1);
    return (real)((Rs + Rp) / 2);
}

color fresnel_conductor(real cosine, color eta, color k) {
    return (color){reflectance(cosine, eta.x, k.x), reflectance(cosine, eta.y, k.y),
                   reflectance(cosine, eta.z, k.z)};
}
