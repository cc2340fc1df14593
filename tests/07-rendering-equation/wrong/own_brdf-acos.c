// Wrong: acos of a dot product that is rounded to more than 1.
// Expect: NaN: acos of a little more than 1, or less than -1?
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double angle = acos((double)dot(neg(reflect(w_i, n)), w_o));
    if (angle > PI / 2) return 0;
    return rho * (shine + 2) / (2 * PI) * pow(cos(angle), shine);
}
