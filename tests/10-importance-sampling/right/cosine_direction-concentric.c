// Right: the square mapped onto the disc ring by ring (Shirley and Chiu 1997), lifted; another frame.
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    const real a = 2 * rng_real(g) - 1;
    const real b = 2 * rng_real(g) - 1;
    const bool wide = fabs(a) > fabs(b);
    const real r = wide ? a : b, quarter = (real)(PI / 4);
    const real phi = r == 0 ? 0 : wide ? quarter * b / a : 2 * quarter - quarter * a / b;
    const vec3 other = fabs(n.z) < (real)0.5 ? (vec3){0, 0, 1} : (vec3){1, 0, 0};
    const vec3 s = normalize(cross(other, n));
    const frame f = {s, cross(n, s), n};
    return to_world(f, (vec3){r * cos(phi), r * sin(phi), sqrt(fmax(1 - r * r, 0))});
}
