// Wrong: always straight up.
// Expect: all draws are alike: is g used?
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    (void)g;
    return n;
}
