// Wrong: no difference cancels, but all is worked out in float.
// Expect: misses it by a rounding: double inside?
// Expect: So little is what rounding does
#include "chapters/10-importance-sampling/importance.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    const vec3 w = sub(S.c, x);
    const float far = (float)length(w), ratio = (float)(S.r / (real)far);
    const float cos_max = (float)sqrt(fmax((1 - ratio) * (1 + ratio), 0));
    const float c = (float)rng_real(g) * ratio * ratio / (1 + cos_max);
    const float phi = (float)(2 * PI) * (float)rng_real(g), sine = (float)sqrt(c * (2 - c));
    const vec3 local = {sine * (float)cos(phi), sine * (float)sin(phi), 1 - c};
    return normalize(to_world(orthonormal_basis(normalize(w)), local));
}
