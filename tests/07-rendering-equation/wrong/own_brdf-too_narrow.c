// Wrong: a power of thousands of millions: the lobe falls between all directions that the judge asks.
// Expect: this lobe falls between them; make it wider
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double along = dot(neg(reflect(w_i, n)), w_o), k = pow(shine, 4);
    return along > 0 ? rho * (k + 2) / (2 * PI) * pow(fmin(along, 1), k) : 0;
}
