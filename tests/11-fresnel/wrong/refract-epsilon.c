// Wrong: an epsilon in place of 0 for total reflection: light just within the critical angle is lost.
// Expect: true: some light goes through
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {

    const double e = eta, c = -(double)dot(d, n), g2 = (e - 1) * (e + 1) + c * c;
    if (!(g2 > 1e-3)) return false;
    *t = keep_unit(add(d, scale((real)(c - sqrt(g2)), n)));
    return true;
}
