// Wrong: the local direction, not turned to n.
// Expect: above the surface
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    (void)n;
    const real r = sqrt(rng_real(g));
    const real phi = (real)(2 * PI) * rng_real(g);
    return (vec3){r * cos(phi), r * sin(phi), sqrt(1 - r * r)};
}
