// Wrong: the factor is shine / (2π), which is 0 for shine = 0.
// Expect: is the factor before the lobe 0 for shine = 0?
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double along = dot(neg(reflect(w_i, n)), w_o);
    return along > 0 ? rho * shine / (2 * PI) * pow(along, shine) : 0;
}
