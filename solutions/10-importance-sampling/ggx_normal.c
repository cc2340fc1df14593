#include "chapters/10-importance-sampling/ggx.h"

// Stretched by alpha the surface is a hemisphere seen from o; what it shows of itself is
// the half of a sphere's cap: o plus a uniform direction of the cap, unstretched.
vec3 ggx_normal(vec3 o, real alpha, rng *g) {
    const vec3 w = normalize((vec3){alpha * o.x, alpha * o.y, o.z});
    const real phi = (real)(2 * PI) * rng_real(g);
    const real z = 1 - rng_real(g) * (1 + w.z);
    const real sine = sqrt(fmax(1 - z * z, 0));
    const vec3 h = {sine * cos(phi) + w.x, sine * sin(phi) + w.y, z + w.z};
    return normalize((vec3){alpha * h.x, alpha * h.y, fmax(h.z, 0)});
}
