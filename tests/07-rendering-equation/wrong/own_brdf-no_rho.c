// Wrong: rho is forgotten.
// Expect: no more light leaves than rho of what arrives
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    (void)rho;
    const double along = fmax(0.0, (double)dot(neg(reflect(w_i, n)), w_o));
    return (shine + 2) / (2 * PI) * pow(along, shine);
}
