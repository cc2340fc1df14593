// Right: n·h, with the factor that its integral gives straight on.
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double k = shine, along = dot(n, normalize(add(w_i, w_o)));
    const double integral = 8 * PI * (pow(2, -k / 2) + k) / ((k + 2) * (k + 4));
    return rho / integral * pow(fmax(0.0, along), k);
}
