// Wrong: n plus a normalised point of the cube, which prefers its corners.
// Expect: The density must be cos θ / π
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    for (;;) {
        const real x = 2 * rng_real(g) - 1, y = 2 * rng_real(g) - 1, z = 2 * rng_real(g) - 1;
        const vec3 v = normalize(add(n, normalize((vec3){x, y, z})));
        if (dot(v, n) > 0) return v;
    }
}
