// Right: on the stretched hemisphere, kept with the chance that w sees it.
#include "chapters/10-importance-sampling/ggx.h"

vec3 ggx_normal(vec3 o, real alpha, rng *g) {
    const vec3 w = normalize((vec3){alpha * o.x, alpha * o.y, o.z});
    for (;;) {
        const vec3 m = hemisphere_direction((vec3){0, 0, 1}, g);
        if (rng_real(g) < dot(w, m)) return normalize((vec3){alpha * m.x, alpha * m.y, m.z});
    }
}
