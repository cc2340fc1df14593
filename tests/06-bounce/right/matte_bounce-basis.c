// Right: polar coordinates with cos²θ uniform, in a basis around n.
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    const real u = rng_real(g);
    const real turn = (real)(2 * PI) * rng_real(g);
    const vec3 other = fabs(n.x) < (real)0.5 ? (vec3){1, 0, 0} : (vec3){0, 1, 0};
    const vec3 a = normalize(cross(n, other)), b = cross(n, a);
    const vec3 across = add(scale(cos(turn), a), scale(sin(turn), b));
    return normalize(add(scale(sqrt(u), across), scale(sqrt(1 - u), n)));
}
