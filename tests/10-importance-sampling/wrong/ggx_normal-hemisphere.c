// Wrong: uniform over the stretched hemisphere.
// Expect: turned away from o is not seen
// Expect: uniform over the stretched hemisphere
#include "chapters/10-importance-sampling/ggx.h"

vec3 ggx_normal(vec3 o, real alpha, rng *g) {
    (void)o;
    const vec3 h = hemisphere_direction((vec3){0, 0, 1}, g);
    return normalize((vec3){alpha * h.x, alpha * h.y, h.z});
}
