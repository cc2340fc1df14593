// Wrong: the angle is divided by eta, not its sine.
// Expect: the angle divided by eta, not its sine
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {

    const real cosine = -dot(d, n), theta = acos(cosine) / eta;
    if (!(theta <= (real)(PI / 2))) return false;
    const vec3 along = normalize(add(d, scale(cosine, n)));
    *t = sub(scale(sin(theta), along), scale(cos(theta), n));
    return true;
}
