// Wrong: the root of a negative number is made 0, and total reflection goes on along the surface.
// Expect: false: nothing goes through
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {

    const double e = eta, c = -(double)dot(d, n), g2 = fmax((e - 1) * (e + 1) + c * c, 0);
    *t = keep_unit(add(d, scale((real)(c - sqrt(g2)), n)));
    return true;
}
