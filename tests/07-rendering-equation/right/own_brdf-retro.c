// Right: a lobe back to where the light came from, as road signs have it.
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    (void)n;
    return rho * (shine + 2) / (2 * PI) * pow(fmax(0.0, (double)dot(w_i, w_o)), shine);
}
