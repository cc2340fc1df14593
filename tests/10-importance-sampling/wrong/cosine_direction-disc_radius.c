// Wrong: a disc whose radius is uniform, lifted: too many in the middle.
// Expect: its radius must be the root
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    const real r = rng_real(g);
    const real phi = (real)(2 * PI) * rng_real(g);
    const vec3 local = {r * cos(phi), r * sin(phi), sqrt(1 - r * r)};
    return keep_unit(to_world(orthonormal_basis(n), local));
}
