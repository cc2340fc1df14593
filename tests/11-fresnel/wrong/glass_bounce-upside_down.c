// Wrong: R with eta upside down.
// Expect: R with eta upside down
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real cosine = fmin(fmax(-dot(d, n), 0), 1);
    const real R = fresnel_dielectric(cosine, 1 / eta);
    const bool mirrored = rng_real(g) < R;
    vec3 t = d;
    if (mirrored || !refract(d, n, eta, &t)) return keep_unit(reflect(d, n));
    return t;
}
