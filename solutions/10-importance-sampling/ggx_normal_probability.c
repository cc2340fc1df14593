#include "chapters/10-importance-sampling/ggx.h"

// G1(o) / o.z = 2 / (o.z + sqrt(o.z² + alpha² (o.x² + o.y²)))
real ggx_normal_probability(vec3 o, vec3 h, real alpha) {
    const real stretched = sqrt(o.z * o.z + alpha * alpha * (o.x * o.x + o.y * o.y));
    return 2 * fmax(dot(o, h), 0) * ggx_density(h, alpha) / (o.z + stretched);
}
