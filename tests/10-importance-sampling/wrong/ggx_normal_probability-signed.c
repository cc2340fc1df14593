// Wrong: negative for what is turned away.
// Expect: the side of a normal that is turned away
#include "chapters/10-importance-sampling/ggx.h"

real ggx_normal_probability(vec3 o, vec3 h, real alpha) {
    const real across = o.x * o.x + o.y * o.y;
    const real stretched = sqrt(o.z * o.z + alpha * alpha * across);
    return 2 * dot(o, h) * ggx_density(h, alpha) / (o.z + stretched);
}
