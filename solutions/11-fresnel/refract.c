#include "chapters/11-fresnel/fresnel.h"

// sin² = (1 - c)(1 + c): nothing cancels near the critical angle. eta² cos² of the far side
// is (eta - 1)(eta + 1) + c².
bool refract(vec3 d, vec3 n, real eta, vec3 *t) {
    const double e = eta, c = -(double)dot(d, n);
    const double k = (e - 1) * (e + 1) + c * c;
    if (!(k >= 0)) return false;
    *t = keep_unit(scale((real)(1 / e), add(d, scale((real)(c - sqrt(k)), n))));
    return true;
}
