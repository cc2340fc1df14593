// Wrong: the right sum, not made a unit vector.
// Expect: a unit vector: normalize the sum
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    return add(n, unit_vector(g));
}
