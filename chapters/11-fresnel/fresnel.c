// fresnel.c: Schlick's approximations and metals. The exact formulas are exercises.
#include "chapters/11-fresnel/fresnel.h"

real schlick_slide(real cosine, real eta) {
    const real r = (eta - 1) / (eta + 1), m = 1 - cosine;
    return r * r + (1 - r * r) * (m * m * m * m * m);
}

// ---- metals ------------------------------------------------------------------------

static real straight_on(real eta, real k) {
    return ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
}

color schlick_conductor(real cosine, color eta, color k) {
    const color R0 = {straight_on(eta.x, k.x), straight_on(eta.y, k.y),
                      straight_on(eta.z, k.z)};
    return schlick_color(R0, cosine);
}

// Measured, at room temperature; linear between the published wavelengths on both sides
// of 650, 550 and 450 nm, rounded to the two decimals that most of them have.
//   Au, Ag, Cu  Johnson and Christy 1972, Phys. Rev. B 6, 4370
//   Al          Rakić 1995, Appl. Opt. 34, 4755
//   Fe, Cr      Johnson and Christy 1974, Phys. Rev. B 9, 5056
//   W           Weaver, Olson and Lynch 1975, Phys. Rev. B 12, 1293, read from their figure
// All as collected by refractiveindex.info (CC0).
const metal metals[] = {
    {"Au", {0.16, 0.42, 1.38}, {3.60, 2.47, 1.92}},
    {"Ag", {0.05, 0.06, 0.04}, {4.41, 3.60, 2.65}},
    {"Cu", {0.24, 1.01, 1.24}, {3.63, 2.58, 2.39}},
    {"Al", {1.56, 1.02, 0.63}, {7.71, 6.63, 5.45}},
    {"Fe", {2.91, 2.95, 2.58}, {3.09, 2.93, 2.77}},
    {"Cr", {3.11, 3.18, 2.32}, {3.33, 3.33, 3.14}},
    {"W", {3.67, 3.52, 3.32}, {2.93, 2.74, 2.52}},
    {0},
};
