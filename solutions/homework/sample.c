// sample.c: random directions, random points.
#include "solutions/homework/raytracer.h"

// A uniform point of the unit sphere around the tip of n: Lambert's directions.
vec3 cosine_direction(vec3 n, rng *g) {
    for (;;) {
        const real x = 2 * rng_real(g) - 1;
        const real y = 2 * rng_real(g) - 1;
        const real s = x * x + y * y;
        if (s >= 1) continue; // Marsaglia 1972
        const real w = 2 * sqrt(1 - s);
        const vec3 v = add(n, (vec3){x * w, y * w, 1 - 2 * s});
        if (dot(v, v) > (real)1e-6) return normalize(v);
    }
}

vec3 lamp_point(const lamp *l, rng *g) {
    const real u = rng_real(g);
    const real v = rng_real(g);
    return add(l->corner, add(scale(u, l->a), scale(v, l->b)));
}
