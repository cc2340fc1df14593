// Wrong: always the same lobe.
// Expect: shine changes the lobe
// Expect: Use shine
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    (void)shine;
    const double along = fmax(0.0, (double)dot(neg(reflect(w_i, n)), w_o));
    return rho * 12 / (2 * PI) * pow(along, 10);
}
