// Wrong: the power of a negative number.
// Expect: NaN: a power or root of a negative number
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    return rho * (shine + 2) / (2 * PI) * pow((double)dot(neg(reflect(w_i, n)), w_o), shine);
}
