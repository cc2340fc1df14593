// Wrong: what is mirrored only above the horizon.
// Expect: it goes down to -w.z
#include "chapters/10-importance-sampling/ggx.h"

vec3 ggx_normal(vec3 o, real alpha, rng *g) {
    const vec3 w = normalize((vec3){alpha * o.x, alpha * o.y, o.z});
    const real phi = (real)(2 * PI) * rng_real(g);
    const real z = 1 - rng_real(g), sine = sqrt(fmax(1 - z * z, 0));
    const vec3 h = {sine * cos(phi) + w.x, sine * sin(phi) + w.y, z + w.z};
    return normalize((vec3){alpha * h.x, alpha * h.y, h.z});
}
