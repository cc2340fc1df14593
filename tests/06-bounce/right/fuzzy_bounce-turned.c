// Right: a direction into the surface is mirrored out of it, not drawn again.
#include "chapters/06-bounce/bounce.h"

vec3 fuzzy_bounce(vec3 d, vec3 n, real fuzz, rng *g) {
    vec3 v = add(reflect(normalize(d), n), scale(fuzz, unit_vector(g)));
    if (dot(v, n) < 0) v = reflect(v, n);
    if (!(dot(v, v) > REAL_EPSILON * REAL_EPSILON)) return n;
    v = normalize(v);
    const real low = 4 * REAL_EPSILON;
    return dot(v, n) > 0 ? v : normalize(add(v, scale(low - dot(v, n), n)));
}
