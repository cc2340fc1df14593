// Right: the albedo over the cosine's integral, which a sum gives.
#include "chapters/07-rendering-equation/rendering.h"

double lambert_brdf(double rho) {
    double measure = 0;
    const int n = 1000; // the midpoint rule is exact for c, whatever n
    for (int i = 0; i < n; i++) measure += 2 * PI * (i + 0.5) / n / n; // ∫ 2π c dc
    return rho / measure;
}
