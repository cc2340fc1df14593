// Wrong: the right sum, also where it is zero or nothing but rounding.
// Expect: where unit_vector(g) gives nearly -n
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    const vec3 v = normalize(add(n, unit_vector(g)));
    return dot(v, v) > 0 ? v : n;
}
