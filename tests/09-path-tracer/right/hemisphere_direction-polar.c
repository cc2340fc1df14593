// Right: a uniform height and a uniform angle, in a basis around n.
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    const real z = rng_real(g), turn = (real)(2 * PI) * rng_real(g);
    const real out = sqrt((1 - z) * (1 + z));
    const vec3 other = fabs(n.x) < (real)0.5 ? (vec3){1, 0, 0} : (vec3){0, 1, 0};
    const vec3 a = normalize(cross(n, other)), b = cross(n, a);
    const vec3 across = add(scale(cos(turn), a), scale(sin(turn), b));
    const vec3 v = normalize(add(scale(out, across), scale(z, n)));
    return dot(v, n) < 0 ? neg(v) : v;
}
