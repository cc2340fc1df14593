// Wrong: the sum is not made a unit vector.
// Expect: : a unit vector)
// Expect: fuzzy_bounce: a unit vector, never into the surface
#include "chapters/06-bounce/bounce.h"

vec3 fuzzy_bounce(vec3 d, vec3 n, real fuzz, rng *g) {
    const vec3 mirrored = reflect(normalize(d), n);
    for (int i = 0; i < 100; i++) {
        const vec3 v = add(mirrored, scale(fuzz, unit_vector(g)));
        if (dot(v, n) > 0) return v;
    }
    return n;
}
