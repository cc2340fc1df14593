// Wrong: a mixture of both directions.
// Expect: a mixture of both directions
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real cosine = fmin(fmax(-dot(d, n), 0), 1);
    const real R = fresnel_dielectric(cosine, eta);
    (void)g;
    vec3 t = d;
    if (!refract(d, n, eta, &t)) return keep_unit(reflect(d, n));
    return add(scale(R, reflect(d, n)), scale(1 - R, t));
}
