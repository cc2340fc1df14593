// scene.c: the triangles that this chapter rasterises and 05-triangle traces.
// Solids that pierce each other, and three blades of which each hides a part of
// the next: no order of drawing is right, only a comparison pixel by pixel.
#include "chapters/01-rasterize/rasterize.h"

// clang-format off
// platform
#define P0 {0.070, -1.130, -4.700}
#define P1 {2.309, -1.130, -4.176}
#define P2 {0.736, -1.130, -2.498}
#define P3 {-1.504, -1.130, -3.023}
#define P4 {-2.169, -1.130, -5.224}
#define P5 {-0.596, -1.130, -6.902}
#define P6 {1.644, -1.130, -6.377}

// icosahedron
#define I0 {-0.018, 0.278, -3.523}
#define I1 {-0.037, 0.820, -4.298}
#define I2 {0.535, 0.067, -4.261}
#define I3 {-0.802, 0.582, -4.802}
#define I4 {0.124, -0.636, -4.743}
#define I5 {-0.770, -0.295, -3.548}
#define I6 {0.082, -0.622, -3.798}
#define I7 {-0.844, 0.596, -3.857}
#define I8 {0.050, 0.255, -5.052}
#define I9 {-0.702, -0.318, -5.077}
#define I10 {-0.683, -0.860, -4.302}
#define I11 {-1.255, -0.107, -4.339}

// spike
#define S0 {0.955, 0.585, -3.906}
#define S1 {-1.917, -0.896, -4.421}
#define S2 {-1.725, -0.903, -5.051}
#define S3 {-2.039, -0.378, -4.809}

// octahedron
#define O0 {1.652, -0.687, -4.273}
#define O1 {0.788, -1.173, -3.527}
#define O2 {1.068, -0.361, -3.706}
#define O3 {1.372, -1.499, -4.094}
#define O4 {1.638, -0.973, -3.444}
#define O5 {0.802, -0.887, -4.356}

// blades
#define B0 {0.796, 0.755, -4.300}
#define B1 {0.709, 1.186, -4.300}
#define B2 {2.487, 1.322, -4.960}
#define B3 {1.771, 0.282, -4.300}
#define B4 {1.441, -0.009, -4.300}
#define B5 {0.434, 1.463, -4.960}
#define B6 {1.693, 1.362, -4.300}
#define B7 {2.110, 1.222, -4.300}
#define B8 {1.339, -0.386, -4.960}

// A paint times k = 0.25 + 0.75 max(0, cos θ), rounded: θ is the angle between
// the triangle's normal and the light's direction (0.45, 0.8, 0.55).
#define STONE(k) {0.50 * k, 0.48 * k, 0.44 * k}
#define SLATE(k) {0.30 * k, 0.31 * k, 0.33 * k}
#define GOLD(k) {1.00 * k, 0.62 * k, 0.12 * k}
#define RED(k) {0.85 * k, 0.10 * k, 0.06 * k}
#define GREEN(k) {0.12 * k, 0.55 * k, 0.20 * k}
#define BLUE(k) {0.10 * k, 0.28 * k, 0.90 * k}
#define TEAL(k) {0.05 * k, 0.50 * k, 0.58 * k}
#define INDIGO(k) {0.22 * k, 0.12 * k, 0.65 * k}
// clang-format on

const color demo_background = {0.55, 0.70, 0.85};

const painted demo_triangles[] = {
    {{P0, P2, P1}, STONE(0.81)},  {{P0, P3, P2}, SLATE(0.81)},  {{P0, P4, P3}, STONE(0.81)},
    {{P0, P5, P4}, SLATE(0.81)},  {{P0, P6, P5}, STONE(0.81)},  {{P0, P1, P6}, SLATE(0.81)},
    {{I0, I2, I1}, GOLD(0.95)},   {{I0, I1, I7}, GOLD(0.95)},   {{I0, I6, I2}, GOLD(0.68)},
    {{I0, I5, I6}, GOLD(0.52)},   {{I0, I7, I5}, GOLD(0.69)},   {{I1, I2, I8}, GOLD(0.68)},
    {{I1, I3, I7}, GOLD(0.69)},   {{I1, I8, I3}, GOLD(0.52)},   {{I2, I6, I4}, GOLD(0.25)},
    {{I2, I4, I8}, GOLD(0.25)},   {{I3, I11, I7}, GOLD(0.26)},  {{I3, I8, I9}, GOLD(0.25)},
    {{I3, I9, I11}, GOLD(0.25)},  {{I4, I6, I10}, GOLD(0.25)},  {{I4, I9, I8}, GOLD(0.25)},
    {{I4, I10, I9}, GOLD(0.25)},  {{I5, I10, I6}, GOLD(0.25)},  {{I5, I7, I11}, GOLD(0.26)},
    {{I5, I11, I10}, GOLD(0.25)}, {{I9, I10, I11}, GOLD(0.25)}, {{S0, S1, S2}, RED(0.25)},
    {{S0, S2, S3}, RED(0.25)},    {{S0, S3, S1}, RED(0.70)},    {{S1, S3, S2}, RED(0.25)},
    {{O0, O2, O4}, GREEN(0.96)},  {{O0, O5, O2}, GREEN(0.43)},  {{O0, O4, O3}, GREEN(0.31)},
    {{O0, O3, O5}, GREEN(0.25)},  {{O1, O4, O2}, GREEN(0.72)},  {{O1, O2, O5}, GREEN(0.25)},
    {{O1, O3, O4}, GREEN(0.25)},  {{O1, O5, O3}, GREEN(0.25)},  {{B0, B2, B1}, BLUE(0.76)},
    {{B3, B5, B4}, TEAL(0.69)},   {{B6, B8, B7}, INDIGO(0.39)},
};
const int demo_triangle_count = COUNT(demo_triangles);
