// Wrong: the dot product is not kept from getting negative.
// Expect: a BRDF is never negative
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double along = dot(neg(reflect(w_i, n)), w_o);
    return rho * (shine + 2) / (2 * PI) * (shine == 1 ? along : pow(fmax(0.0, along), shine));
}
