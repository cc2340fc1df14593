// Right: by Smith's Λ, with the tangent of o; level with the surface the limit of it.
#include "chapters/10-importance-sampling/ggx.h"

real ggx_normal_probability(vec3 o, vec3 h, real alpha) {
    const real c = fmax(dot(o, h), 0), flat = sqrt(o.x * o.x + o.y * o.y);
    if (o.z <= 0) return 2 * c * ggx_density(h, alpha) / (alpha * flat);
    const real k = alpha * flat / o.z, lambda = (sqrt(1 + k * k) - 1) / 2;
    return c * ggx_density(h, alpha) / (o.z * (1 + lambda));
}
