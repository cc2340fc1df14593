// Wrong: mirrored about the y axis of the world, not about n.
// Expect: f may use n, w_i and w_o, and no axis of the world
#include "chapters/07-rendering-equation/rendering.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    (void)n;
    const vec3 r = neg(reflect(w_i, (vec3){0, 1, 0}));
    return 0.1 * rho * (shine + 2) / (2 * PI) * pow(fmax(0.0, (double)dot(r, w_o)), shine);
}
