// Wrong: a generator of its own, the same every time.
// Expect: is g used?
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real cosine = fmin(fmax(-dot(d, n), 0), 1);
    const real R = fresnel_dielectric(cosine, eta);
    rng own = rng_seed(1, 1);
    (void)g;
    const bool mirrored = rng_real(&own) < R;
    vec3 t = d;
    if (mirrored || !refract(d, n, eta, &t)) return keep_unit(reflect(d, n));
    return t;
}
