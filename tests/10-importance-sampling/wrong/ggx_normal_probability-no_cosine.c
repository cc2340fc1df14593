// Wrong: o·h is missing.
// Expect: o·h is missing
#include "chapters/10-importance-sampling/ggx.h"

real ggx_normal_probability(vec3 o, vec3 h, real alpha) {
    const real across = o.x * o.x + o.y * o.y;
    const real stretched = sqrt(o.z * o.z + alpha * alpha * across);
    return dot(o, h) > 0 ? 2 * ggx_density(h, alpha) / (o.z + stretched) : 0;
}
