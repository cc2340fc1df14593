// Wrong: the lobe without its factor: sharp lobes reflect next to nothing.
// Expect: a narrow lobe must be higher: does the factor grow with shine?
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    return rho / (2 * PI) * pow(fmax(0.0, (double)dot(neg(reflect(w_i, n)), w_o)), shine);
}
