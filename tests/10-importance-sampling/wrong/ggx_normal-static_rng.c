// Wrong: a generator that lives from call to call: every run of the threads is another picture.
// Expect: numbers that do not come from g
#include "chapters/10-importance-sampling/ggx.h"

vec3 ggx_normal(vec3 o, real alpha, rng *g) {
    static rng own = {1, 3};
    (void)g;
    const vec3 w = normalize((vec3){alpha * o.x, alpha * o.y, o.z});
    const real phi = (real)(2 * PI) * rng_real(&own);
    const real u = rng_real(&own), all = 1 + w.z, up = (1 - u) * all;
    const real below = (w.x * w.x + w.y * w.y) / all;
    const real sine = sqrt(u * all * (below + up));
    const vec3 h = {sine * cos(phi) + w.x, sine * sin(phi) + w.y, up};
    return normalize((vec3){alpha * h.x, alpha * h.y, h.z});
}
