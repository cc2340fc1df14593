// Wrong: a generator of its own, which draws the same every time.
// Expect: the draws differ
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    rng mine = *g;
    const real r = sqrt(rng_real(&mine));
    const real phi = (real)(2 * PI) * rng_real(&mine);
    const vec3 local = {r * cos(phi), r * sin(phi), sqrt(1 - r * r)};
    return keep_unit(to_world(orthonormal_basis(n), local));
}
