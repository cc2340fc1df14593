// Wrong: w_i points away from the surface, and is mirrored as if it pointed towards it.
// Expect: is the mirrored direction turned the wrong way?
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double along = fmax(0.0, (double)dot(reflect(w_i, n), w_o));
    return rho * (shine + 2) / (2 * PI) * pow(along, shine);
}
