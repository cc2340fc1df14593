// Right: total reflection first, and only then a number is drawn, compared the other way round.
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real cosine = fmin(fmax(-dot(d, n), 0), 1);
    const real R = fresnel_dielectric(cosine, eta);
    vec3 t = d;
    if (!refract(d, n, eta, &t)) return keep_unit(reflect(d, n));
    return 1 - rng_real(g) <= R ? keep_unit(reflect(d, n)) : t;
}
