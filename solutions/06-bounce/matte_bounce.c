#include "chapters/06-bounce/bounce.h"

// n plus a point of the unit sphere. Below a few roundings the sum is only noise
// (the point was -n), and is drawn again.
vec3 matte_bounce(vec3 n, rng *g) {
    for (;;) {
        const vec3 v = add(n, unit_vector(g));
        if (dot(v, v) < 64 * REAL_EPSILON * REAL_EPSILON) continue;
        const vec3 d = normalize(v);
        if (!(dot(d, n) <= 0)) return d; // NaN, from a bad n, goes out, not on for ever
    }
}
