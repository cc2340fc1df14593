// Right: a point of the ball by rejection, made a unit vector.
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    for (;;) {
        const real x = 2 * rng_real(g) - 1, y = 2 * rng_real(g) - 1, z = 2 * rng_real(g) - 1;
        const vec3 v = {x, y, z};
        const real square = dot(v, v);
        if (square > 1 || square < (real)1e-4) continue;
        return scale((dot(v, n) < 0 ? -1 : 1) / sqrt(square), v);
    }
}
