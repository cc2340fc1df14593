// Wrong: a point in the ball, not made a unit vector.
// Expect: a unit vector
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    for (;;) {
        const real x = 2 * rng_real(g) - 1, y = 2 * rng_real(g) - 1, z = 2 * rng_real(g) - 1;
        const vec3 v = {x, y, z};
        if (dot(v, v) <= 1) return dot(v, n) < 0 ? neg(v) : v;
    }
}
