// Wrong: G1 over o.z as written: 0/0 at o.z = 0.
// Expect: NaN: 0/0
#include "chapters/10-importance-sampling/ggx.h"

real ggx_normal_probability(vec3 o, vec3 h, real alpha) {
    const real across = o.x * o.x + o.y * o.y;
    const real stretched = sqrt(o.z * o.z + alpha * alpha * across);
    const real G1 = 2 * o.z / (o.z + stretched);
    return G1 * fmax(dot(o, h), 0) * ggx_density(h, alpha) / o.z;
}
