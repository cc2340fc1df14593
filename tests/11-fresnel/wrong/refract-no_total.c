// Wrong: total reflection is forgotten: the root of a negative number.
// Expect: no NaN: there is no root of a negative number
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {

    const double e = eta, c = -(double)dot(d, n), g2 = (e - 1) * (e + 1) + c * c;
    *t = keep_unit(add(d, scale((real)(c - sqrt(g2)), n)));
    return true;
}
