// Wrong: a random unit vector, also into the surface.
// Expect: Can the sum be zero, or end below the surface?
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    (void)n;
    return unit_vector(g);
}
