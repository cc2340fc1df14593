// Wrong: a normalised point of the cube, which prefers its corners.
// Expect: what shape are the random points taken
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    const real x = 2 * rng_real(g) - 1, y = 2 * rng_real(g) - 1, z = 2 * rng_real(g) - 1;
    const vec3 v = normalize((vec3){x, y, z});
    return dot(v, n) < 0 ? neg(v) : v;
}
