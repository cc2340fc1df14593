// Wrong: only the part in the surface is changed, and the sum made a unit vector.
// Expect: cos θ in place of cos θ_t
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {

    const real cosine = -dot(d, n);
    const vec3 in_surface = add(d, scale(cosine, n));
    if (!(length(in_surface) <= eta)) return false;
    *t = normalize(sub(scale(1 / eta, in_surface), scale(cosine, n)));
    return true;
}
