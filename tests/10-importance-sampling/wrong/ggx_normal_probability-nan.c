// Wrong: NaN for ordinary normals.
// Expect: NaN: 0/0
#include "chapters/10-importance-sampling/ggx.h"

real ggx_normal_probability(vec3 o, vec3 h, real alpha) {
    const real across = o.x * o.x + o.y * o.y;
    const real stretched = sqrt(o.z * o.z - 1 - alpha * alpha * across);
    return 2 * fmax(dot(o, h), 0) * ggx_density(h, alpha) / (o.z + stretched);
}
