// Wrong: all normals of the surface, seen or not.
// Expect: turned away from o is not seen
// Expect: with the density D h.z, not those seen from o
#include "chapters/10-importance-sampling/ggx.h"

vec3 ggx_normal(vec3 o, real alpha, rng *g) {
    (void)o;
    const real u = rng_real(g);
    const real phi = (real)(2 * PI) * rng_real(g), tangent = alpha * sqrt(u / (1 - u));
    return normalize((vec3){tangent * cos(phi), tangent * sin(phi), 1});
}
