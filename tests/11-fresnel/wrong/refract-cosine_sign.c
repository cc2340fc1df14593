// Wrong: cos θ = d·n, without the minus.
// Expect: c = d·n: the sign is missing, cos θ = -d·n
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {

    const double e = eta, c = (double)dot(d, n), g2 = (e - 1) * (e + 1) + c * c;
    if (!(g2 >= 0)) return false;
    *t = scale((real)(1 / e), add(d, scale((real)(c - sqrt(g2)), n)));
    return true;
}
