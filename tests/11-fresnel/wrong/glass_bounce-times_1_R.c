// Wrong: the refracted direction times 1 - R: its chance is not cancelled.
// Expect: 1 - R times the direction: it is the chance to be drawn, and cancels
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real R = fresnel_dielectric(fmin(fmax(-dot(d, n), 0), 1), eta);
    vec3 t = d;
    if (rng_real(g) < R || !refract(d, n, eta, &t)) return keep_unit(reflect(d, n));
    return scale(1 - R, t);
}
