#include "chapters/10-importance-sampling/ggx.h"

// Stretched by alpha the surface becomes a hemisphere, seen from w. What it mirrors of w lies
// uniformly in the cap z > -w.z: z = 1 - u (1 + w.z). The normal is half way between w and
// that, and is stretched back. 1 - z, 1 + z and z + w.z as sums of what is positive.
vec3 ggx_normal(vec3 o, real alpha, rng *g) {
    const vec3 w = normalize((vec3){alpha * o.x, alpha * o.y, o.z});
    const real phi = (real)(2 * PI) * rng_real(g);
    const real u = rng_real(g), all = 1 + w.z, up = (1 - u) * all;
    const real below = (w.x * w.x + w.y * w.y) / all; // 1 - w.z
    const real sine = sqrt(u * all * (below + up));
    const vec3 h = {sine * cos(phi) + w.x, sine * sin(phi) + w.y, up};
    return normalize((vec3){alpha * h.x, alpha * h.y, h.z});
}
