#include "chapters/07-rendering-equation/rendering.h"

// The modified Phong lobe, (k + 2)/(2π) rho max(0, r·w_o)^k with k = shine: w_i points away
// from the surface, so its mirror image about n is r = -reflect(w_i, n). Straight on, the
// lobe's integral with the cosine is 2π/(k + 2): the factor makes it rho. At the angle
// θ from n it is rho cos θ, and more, but never more than rho, where the horizon cuts
// the lobe. Source: Lafortune and Willems 1994.
double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double along = dot(neg(reflect(w_i, n)), w_o);
    if (along <= 0) return 0;
    return rho * (shine + 2) / (2 * PI) * pow(along, shine);
}
