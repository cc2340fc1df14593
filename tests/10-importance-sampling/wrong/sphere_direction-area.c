// Wrong: towards a uniform point of the whole sphere.
// Expect: uniform points of the whole sphere
#include "chapters/10-importance-sampling/importance.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    return normalize(sub(add(S.c, scale(S.r, unit_vector(g))), x));
}
