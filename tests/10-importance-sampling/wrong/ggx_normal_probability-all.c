// Wrong: the density of all normals, seen or not.
// Expect: all normals, whether o sees them or not
#include "chapters/10-importance-sampling/ggx.h"

real ggx_normal_probability(vec3 o, vec3 h, real alpha) {
    const real across = o.x * o.x + o.y * o.y;
    const real stretched = sqrt(o.z * o.z + alpha * alpha * across);
    return ggx_density(h, alpha) * fmax(h.z, 0) + 0 * stretched;
}
