// Right: shine squared as the power: a lobe of 0.005 radians for shine = 200.
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double along = dot(neg(reflect(w_i, n)), w_o), k = shine * shine;
    return along > 0 ? rho * (k + 2) / (2 * PI) * pow(fmin(along, 1), k) : 0;
}
