// Wrong: φ only from 0 to π.
// Expect: the cells of one half of the angle are empty
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    const real r = sqrt(rng_real(g));
    const real phi = (real)PI * rng_real(g);
    const vec3 local = {r * cos(phi), r * sin(phi), sqrt(1 - r * r)};
    return keep_unit(to_world(orthonormal_basis(n), local));
}
