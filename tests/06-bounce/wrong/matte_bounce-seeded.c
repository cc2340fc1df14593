// Wrong: a freshly seeded generator in place of g, which draws the same every time.
// Expect: all draws are alike: is g used?
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    (void)g;
    rng mine = rng_seed(1, 1);
    return normalize(add(n, unit_vector(&mine)));
}
