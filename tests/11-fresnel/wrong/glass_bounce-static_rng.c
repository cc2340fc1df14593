// Wrong: a generator that lives from call to call: every run of the threads is another picture.
// Expect: numbers that do not come from g
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    static rng own = {1, 3};
    (void)g;
    const real R = fresnel_dielectric(fmin(fmax(-dot(d, n), 0), 1), eta);
    vec3 t;
    if (rng_real(&own) < R || !refract(d, n, eta, &t)) return keep_unit(reflect(d, n));
    return t;
}
