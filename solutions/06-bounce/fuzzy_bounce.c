#include "chapters/06-bounce/bounce.h"

enum { TRIES = 64 };

// For fuzz = 0 every try is the same, and at grazing angles rounding may put even
// the mirrored direction into the surface: then it is lifted just out of it.
vec3 fuzzy_bounce(vec3 d, vec3 n, real fuzz, rng *g) {
    const vec3 mirrored = reflect(normalize(d), n);
    for (int i = 0; i < TRIES; i++) {
        const vec3 v = normalize(add(mirrored, scale(fuzz, unit_vector(g))));
        if (dot(v, n) > 0) return v; // NaN, from the zero vector, is not
    }
    return normalize(add(mirrored, scale(4 * REAL_EPSILON - dot(mirrored, n), n)));
}
