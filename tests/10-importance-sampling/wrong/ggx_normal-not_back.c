// Wrong: the normal is not stretched back.
// Expect: turned away from o is not seen
// Expect: not stretched back by alpha
#include "chapters/10-importance-sampling/ggx.h"

vec3 ggx_normal(vec3 o, real alpha, rng *g) {
    const vec3 w = normalize((vec3){alpha * o.x, alpha * o.y, o.z});
    const real phi = (real)(2 * PI) * rng_real(g);
    const real u = rng_real(g), z = 1 - u * (1 + w.z), sine = sqrt(fmax(1 - z * z, 0));
    return normalize((vec3){sine * cos(phi) + w.x, sine * sin(phi) + w.y, fmax(z + w.z, 0)});
}
