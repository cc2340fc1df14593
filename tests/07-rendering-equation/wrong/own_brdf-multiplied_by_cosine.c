// Wrong: the cosine of w_i stands in the BRDF too.
// Expect: multiplied by the cosine of w_i
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double along = fmax(0.0, (double)dot(neg(reflect(w_i, n)), w_o));
    return rho * (shine + 2) / (2 * PI) * pow(along, shine) * (double)dot(w_i, n);
}
