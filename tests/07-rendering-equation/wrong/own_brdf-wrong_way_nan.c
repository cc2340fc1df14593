// Wrong: the same without the clamp: a power of a negative number.
// Expect: If of r·w_o: is the mirrored direction turned the wrong way?
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double along = (double)dot(reflect(w_i, n), w_o);
    return rho * (shine + 2) / (2 * PI) * pow(along, shine + 0.5);
}
