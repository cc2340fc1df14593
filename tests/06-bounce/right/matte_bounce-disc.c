// Right: a uniform point of the disc, lifted to the hemisphere.
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    real x, y, s;
    do {
        x = 2 * rng_real(g) - 1;
        y = 2 * rng_real(g) - 1;
        s = x * x + y * y;
    } while (s >= 1);
    const vec3 other = fabs(n.y) < (real)0.5 ? (vec3){0, 1, 0} : (vec3){0, 0, 1};
    const vec3 a = normalize(cross(other, n)), b = cross(n, a);
    return normalize(add(add(scale(x, a), scale(y, b)), scale(sqrt(1 - s), n)));
}
