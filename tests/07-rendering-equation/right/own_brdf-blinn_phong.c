// Right: n·h, with a factor that is safe for it.
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const vec3 h = normalize(add(w_i, w_o));
    return rho * (shine + 2) / (8 * PI) * pow(fmax(0.0, (double)dot(n, h)), shine);
}
