// Wrong: the index upside down: sin θ_t = eta sin θ.
// Expect: eta upside down: sin θ_t = eta sin θ
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {

    const double e = 1 / (double)eta, c = -(double)dot(d, n), g2 = (e - 1) * (e + 1) + c * c;
    if (!(g2 >= 0)) return false;
    *t = keep_unit(add(d, scale((real)(c - sqrt(g2)), n)));
    return true;
}
