// fresnel.c: Schlick's approximations and metals. The exact formulas are exercises.
#include "chapters/11-fresnel/fresnel.h"

real schlick_slide(real cosine, real eta) {
    const real r = (eta - 1) / (eta + 1), m = 1 - cosine;
    return r * r + (1 - r * r) * (m * m * m * m * m);
}

static real straight_on(real eta, real k) {
    return ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
}

color schlick_conductor(real cosine, color eta, color k) {
    const color R0 = {straight_on(eta.x, k.x), straight_on(eta.y, k.y),
                      straight_on(eta.z, k.z)};
    return schlick_color(R0, cosine);
}

#define RGB(r, g, b) \
    { (real)(r), (real)(g), (real)(b) }
const metal metals[] = {
    {"Au", RGB(0.155, 0.424, 1.506), RGB(3.54, 2.46, 1.90)},
    {"Ag", RGB(0.053, 0.060, 0.040), RGB(4.10, 3.59, 2.65)},
    {"Cu", RGB(0.214, 1.02, 1.25), RGB(3.67, 2.58, 2.38)},
    {"Al", RGB(1.47, 0.96, 0.62), RGB(7.8, 6.7, 5.47)},
    {"Fe", RGB(2.91, 2.95, 2.66), RGB(3.06, 2.93, 2.88)},
    {"Cr", RGB(3.11, 3.18, 2.33), RGB(3.33, 3.33, 3.14)},
    {"W", RGB(3.60, 3.50, 3.31), RGB(2.89, 2.73, 2.55)},
    {0},
};
