// Wrong: n plus a point in the ball, not on the sphere: cos³.
// Expect: a density of cos³
#include "chapters/10-importance-sampling/importance.h"

static vec3 in_ball(rng *g) {
    for (;;) {
        const real x = 2 * rng_real(g) - 1, y = 2 * rng_real(g) - 1, z = 2 * rng_real(g) - 1;
        const vec3 v = {x, y, z};
        if (dot(v, v) <= 1) return v;
    }
}

vec3 cosine_direction(vec3 n, rng *g) {
    return normalize(add(n, in_ball(g)));
}
