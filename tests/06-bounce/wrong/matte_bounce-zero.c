// Wrong: a sum of zero is normalised.
// Expect: not NaN: what is normalize(n + u) when u is -n?
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    return normalize(add(n, unit_vector(g)));
}
