// Wrong: at most R, not below: the number 0 is drawn too, where R is 0.
// Expect: Below R is the chance R
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real R = fresnel_dielectric(fmin(fmax(-dot(d, n), 0), 1), eta);
    vec3 t;
    if (rng_real(g) <= R || !refract(d, n, eta, &t)) return keep_unit(reflect(d, n));
    return t;
}
