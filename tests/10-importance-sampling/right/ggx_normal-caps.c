// Right: Dupuy and Benyoub 2023 as published: the cap's height by lerp.
#include "chapters/10-importance-sampling/ggx.h"

vec3 ggx_normal(vec3 o, real alpha, rng *g) {
    const vec3 w = normalize((vec3){alpha * o.x, alpha * o.y, o.z});
    const real phi = (real)(2 * PI) * rng_real(g);
    const real u = rng_real(g), z = (1 - u) * (1 + w.z) - w.z;
    const real sine = sqrt(fmin(fmax(1 - z * z, 0), 1));
    const vec3 h = {sine * cos(phi) + w.x, sine * sin(phi) + w.y, fmax(z + w.z, 0)};
    return normalize((vec3){alpha * h.x, alpha * h.y, h.z});
}
