// Wrong: n plus a point in the ball, not on the sphere.
// Expect: a density of cos³
#include "chapters/06-bounce/bounce.h"

static vec3 in_ball(rng *g) {
    for (;;) {
        const real x = 2 * rng_real(g) - 1, y = 2 * rng_real(g) - 1, z = 2 * rng_real(g) - 1;
        const vec3 v = {x, y, z};
        if (dot(v, v) <= 1) return v;
    }
}

vec3 matte_bounce(vec3 n, rng *g) {
    return normalize(add(n, in_ball(g)));
}
