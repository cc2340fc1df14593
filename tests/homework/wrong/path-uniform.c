// Wrong: directions uniform on the hemisphere, weighted as if chosen by the cosine.
// Expect: the directions are uniform, but weighted as if chosen by the cosine
// Stage: path
#include "solutions/homework/raytracer.h"

static vec3 uniform_direction(vec3 n, rng *g) {
    const vec3 v = cosine_direction((vec3){0, 0, 0}, g); // the whole sphere
    return dot(n, v) < 0 ? neg(v) : v;
}
#define cosine_direction(n, g) uniform_direction(n, g)
#include "solutions/homework/path.c"
