// Wrong: divided by both cosines: reciprocal, and without bound at grazing angles.
// Expect: no more light leaves than rho of what arrives
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double along = fmax(0.0, (double)dot(neg(reflect(w_i, n)), w_o));
    const double cosines = (double)dot(w_i, n) * (double)dot(w_o, n);
    return rho * (shine + 1) / (2 * PI) * pow(along, shine) / cosines;
}
