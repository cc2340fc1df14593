// Wrong: refract is given n on the far side.
// Expect: One number decides
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real cosine = fmin(fmax(-dot(d, n), 0), 1);
    const real R = fresnel_dielectric(cosine, eta);
    const bool mirrored = rng_real(g) < R;
    vec3 t = d;
    if (mirrored || !refract(d, neg(n), eta, &t)) return keep_unit(reflect(d, n));
    return t;
}
