// Wrong: all in real arithmetic.
// Expect: misses it by a rounding: double inside?
#include "chapters/10-importance-sampling/importance.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    const vec3 w = sub(S.c, x);
    const real cos_max = sqrt(fmax(1 - S.r * S.r / dot(w, w), 0));
    const real z = 1 - rng_real(g) * (1 - cos_max);
    const real phi = (real)(2 * PI) * rng_real(g), sine = sqrt(fmax(1 - z * z, 0));
    const vec3 local = {sine * cos(phi), sine * sin(phi), z};
    return normalize(to_world(orthonormal_basis(normalize(w)), local));
}
