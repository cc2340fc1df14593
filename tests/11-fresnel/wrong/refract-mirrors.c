// Wrong: on total reflection the mirrored ray is put into *t.
// Expect: (7, 8, 9)
// Expect: Decide before you take it
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {

    const double e = eta, c = -(double)dot(d, n), g2 = (e - 1) * (e + 1) + c * c;
    *t = reflect(d, n);
    if (!(g2 >= 0)) return false;
    *t = keep_unit(add(d, scale((real)(c - sqrt(g2)), n)));
    return true;
}
