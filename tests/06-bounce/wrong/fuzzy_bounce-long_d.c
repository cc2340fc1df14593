// Wrong: the random vector is added to a d of any length.
// Expect: d was not made a unit vector first
#include "chapters/06-bounce/bounce.h"

vec3 fuzzy_bounce(vec3 d, vec3 n, real fuzz, rng *g) {
    for (int i = 0; i < 100; i++) {
        const vec3 v = normalize(add(reflect(d, n), scale(fuzz, unit_vector(g))));
        if (dot(v, n) > 0) return v;
    }
    return n;
}
