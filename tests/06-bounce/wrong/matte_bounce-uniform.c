// Wrong: uniform over the hemisphere, without the cosine.
// Expect: uniform over the hemisphere: the cosine is missing
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    const vec3 v = unit_vector(g);
    return dot(v, n) < 0 ? neg(v) : v;
}
