// Wrong: n is taken on the wrong side: + before the root.
// Expect: n on the wrong side, or c + g in place of c - g
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {

    const double e = eta, c = -(double)dot(d, n), g2 = (e - 1) * (e + 1) + c * c;
    if (!(g2 >= 0)) return false;
    *t = keep_unit(add(d, scale((real)(c + sqrt(g2)), n)));
    return true;
}
