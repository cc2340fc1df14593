// Wrong: one of the two numbers is C's own.
// Expect: numbers that do not come from g
#include "chapters/10-importance-sampling/importance.h"

#include <stdlib.h>

vec3 cosine_direction(vec3 n, rng *g) {
    const real r = sqrt(rng_real(g));
    const double turns = rand() / (RAND_MAX + 1.0);
    const real phi = (real)(2 * PI * turns);
    const vec3 local = {r * cos(phi), r * sin(phi), sqrt(1 - r * r)};
    return keep_unit(to_world(orthonormal_basis(n), local));
}
