// Wrong: the cosine with the sign of d·n, a number below 0.
// Expect: always mirrored: is cosine = -d·n?
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real cosine = dot(d, n);
    const real R = fresnel_dielectric(cosine, eta);
    const bool mirrored = rng_real(g) < R;
    vec3 t = d;
    if (mirrored || !refract(d, n, eta, &t)) return keep_unit(reflect(d, n));
    return t;
}
