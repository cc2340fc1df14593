// Wrong: cos θ uniform from 0 to 1: the whole hemisphere towards the sphere.
// Expect: the ray (x, v) meets the sphere
#include "chapters/10-importance-sampling/importance.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    return hemisphere_direction(normalize(sub(S.c, x)), g);
}
