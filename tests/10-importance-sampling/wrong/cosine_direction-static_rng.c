// Wrong: a generator that lives from call to call: every run of the threads is another picture.
// Expect: numbers that do not come from g
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    static rng own = {1, 3};
    (void)g;
    const real r = sqrt(rng_real(&own));
    const real phi = (real)(2 * PI) * rng_real(&own);
    const vec3 local = {r * cos(phi), r * sin(phi), sqrt(1 - r * r)};
    return keep_unit(to_world(orthonormal_basis(n), local));
}
