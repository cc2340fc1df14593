// Wrong: a generator that lives from call to call.
// Expect: numbers that do not come from g
#include "chapters/06-bounce/bounce.h"

enum { TRIES = 64 };

vec3 fuzzy_bounce(vec3 d, vec3 n, real fuzz, rng *g) {
    static rng own = {1, 3};
    (void)g;
    const vec3 mirrored = reflect(normalize(d), n);
    for (int i = 0; i < TRIES; i++) {
        const vec3 v = normalize(add(mirrored, scale(fuzz, unit_vector(&own))));
        if (dot(v, n) > 0) return v; // NaN, from the zero vector, is not
    }
    return normalize(add(mirrored, scale(4 * REAL_EPSILON - dot(mirrored, n), n)));
}
