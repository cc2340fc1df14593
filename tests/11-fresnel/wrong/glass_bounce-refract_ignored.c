// Wrong: refract's answer is not looked at.
// Expect: What did refract return?
// Expect: What if R says through, but refract says false?
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real R = fresnel_dielectric(-dot(d, n), eta);
    if (rng_real(g) < R) return keep_unit(reflect(d, n));
    vec3 t = d;
    refract(d, n, eta, &t);
    return t;
}
