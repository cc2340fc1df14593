// Wrong: a basis by the cross product with one axis, whatever n is.
// Expect: finite, no NaN
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    const vec3 s = normalize(cross((vec3){0, 0, 1}, n));
    const frame f = {s, cross(n, s), n};
    const real r = sqrt(rng_real(g));
    const real phi = (real)(2 * PI) * rng_real(g);
    return to_world(f, (vec3){r * cos(phi), r * sin(phi), sqrt(1 - r * r)});
}
