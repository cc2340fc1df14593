// Wrong: the lamp's light without the cosine at the lamp.
// Expect: the cosine at the lamp is missing
// Stage: path
#include "solutions/homework/raytracer.h"

static real slope(vec3 n, vec3 d) {
    return dot(n, d) / length(d);
}
#define geometry(x, n, y, m) (geometry(x, n, y, m) / slope(m, sub(x, y)))
#include "solutions/homework/path.c"
