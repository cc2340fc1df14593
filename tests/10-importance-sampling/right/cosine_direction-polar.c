// Right: by the inverse of the cumulative density, in polar coordinates.
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    const real u = rng_real(g);
    const real phi = (real)(2 * PI) * rng_real(g), r = sqrt(1 - u);
    const vec3 local = {r * cos(phi), r * sin(phi), sqrt(u)};
    return keep_unit(to_world(orthonormal_basis(n), local));
}
