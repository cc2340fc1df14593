// Wrong: draws again for ever, where every draw is the same.
// Expect: endless loop
// Expect: fuzz = 0, every draw is the same
#include "chapters/06-bounce/bounce.h"

vec3 fuzzy_bounce(vec3 d, vec3 n, real fuzz, rng *g) {
    for (;;) {
        const vec3 v = normalize(add(reflect(normalize(d), n), scale(fuzz, unit_vector(g))));
        if (dot(v, n) > 0) return v;
    }
}
