// Wrong: one random number for radius and angle.
// Expect: chi² that a right answer exceeds
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    const real u = rng_real(g), r = sqrt(u), phi = (real)(2 * PI) * u;
    const vec3 local = {r * cos(phi), r * sin(phi), sqrt(1 - u)};
    return keep_unit(to_world(orthonormal_basis(n), local));
}
