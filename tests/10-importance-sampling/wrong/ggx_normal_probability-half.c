// Wrong: the 2 of G1 is missing.
// Expect: half the expected
#include "chapters/10-importance-sampling/ggx.h"

real ggx_normal_probability(vec3 o, vec3 h, real alpha) {
    const real across = o.x * o.x + o.y * o.y;
    const real stretched = sqrt(o.z * o.z + alpha * alpha * across);
    return fmax(dot(o, h), 0) * ggx_density(h, alpha) / (o.z + stretched);
}
