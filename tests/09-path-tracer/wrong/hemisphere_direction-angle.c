// Wrong: uniform in the angle θ to n, and so too often near n.
// Expect: uniform in the angle θ: crowded around n
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    const real theta = (real)(PI / 2) * rng_real(g);
    const real turn = (real)(2 * PI) * rng_real(g);
    const vec3 other = fabs(n.x) < (real)0.5 ? (vec3){1, 0, 0} : (vec3){0, 1, 0};
    const vec3 a = normalize(cross(n, other)), b = cross(n, a);
    const vec3 across = add(scale(cos(turn), a), scale(sin(turn), b));
    return normalize(add(scale(sin(theta), across), scale(cos(theta), n)));
}
