// Wrong: the direction times R: the chance is not cancelled.
// Expect: R times the direction: R is the chance to be drawn, and cancels
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real cosine = fmin(fmax(-dot(d, n), 0), 1);
    const real R = fresnel_dielectric(cosine, eta);
    const bool mirrored = rng_real(g) < R;
    vec3 t = d;
    if (mirrored || !refract(d, n, eta, &t)) return scale(R, keep_unit(reflect(d, n)));
    return scale(R, t);
}
