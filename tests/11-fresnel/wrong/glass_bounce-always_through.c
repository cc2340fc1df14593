// Wrong: R is not asked: light is mirrored only on total reflection.
// Expect: never mirrored
#include "chapters/11-fresnel/fresnel.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    (void)g;
    vec3 t = d;
    if (!refract(d, n, eta, &t)) return keep_unit(reflect(d, n));
    return t;
}
