// Wrong: a number drawn for the reflected ray, and another one for the refracted.
// Expect: one number of g decides
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    const real R = fresnel_dielectric(-dot(d, n), eta);
    vec3 t = d;
    const bool through = refract(d, n, eta, &t);
    for (;;) {
        if (!through || rng_real(g) < R) return keep_unit(reflect(d, n));
        if (rng_real(g) < 1 - R) return t;
    }
}
