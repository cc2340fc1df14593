// Wrong: the lamp's light without the cosine at the surface.
// Expect: the cosine at the surface, n·v, is missing
// Stage: path
#include "solutions/homework/raytracer.h"

static real slope(vec3 n, vec3 d) {
    return dot(n, d) / length(d);
}
#define geometry(x, n, y, m) (geometry(x, n, y, m) / slope(n, sub(y, x)))
#include "solutions/homework/path.c"
