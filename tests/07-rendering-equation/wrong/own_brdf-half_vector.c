// Wrong: n·h in the lobe with the factor that belongs to r·w_o: it gains energy.
// Expect: no more light leaves than rho of what arrives
// Expect: The lobe's integral with the cosine must not exceed rho
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const vec3 h = normalize(add(w_i, w_o));
    return rho * (shine + 2) / (2 * PI) * pow(fmax(0.0, (double)dot(n, h)), shine);
}
