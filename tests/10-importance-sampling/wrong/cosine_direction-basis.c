// Wrong: a basis that divides by 1 + n.z: NaN for (0, 0, -1).
// Expect: finite, no NaN
// Expect: (0, 0, -1) and all around it too
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    const real a = 1 / (1 + n.z), b = -n.x * n.y * a;
    const frame f = {{1 - n.x * n.x * a, b, -n.x}, {b, 1 - n.y * n.y * a, -n.y}, n};
    const real r = sqrt(rng_real(g));
    const real phi = (real)(2 * PI) * rng_real(g);
    return keep_unit(to_world(f, (vec3){r * cos(phi), r * sin(phi), sqrt(1 - r * r)}));
}
