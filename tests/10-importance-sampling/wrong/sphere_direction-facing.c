// Wrong: towards a uniform point of the side that is seen.
// Expect: uniform points of the side that is seen
#include "chapters/10-importance-sampling/importance.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    const vec3 back = sub(x, S.c);
    for (;;) {
        const vec3 u = unit_vector(g);
        if (dot(u, back) > S.r) return normalize(sub(add(S.c, scale(S.r, u)), x));
    }
}
