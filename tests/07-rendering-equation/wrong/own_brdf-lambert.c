// Wrong: Lambert's, again.
// Expect: it has a lobe, unlike Lambert's
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    (void)shine, (void)n, (void)w_i, (void)w_o;
    return lambert_brdf(rho);
}
