// Wrong: the angle θ is uniform.
// Expect: the angle θ is uniform
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    const real theta = (real)(PI / 2) * rng_real(g);
    const real phi = (real)(2 * PI) * rng_real(g);
    const vec3 local = {sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)};
    return keep_unit(to_world(orthonormal_basis(n), local));
}
