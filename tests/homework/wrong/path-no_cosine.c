// Wrong: the lamp's light without the cosine at the surface.
// Expect: the cosine at the surface, n·v, is missing
// Stage: path
#include "solutions/homework/raytracer.h"

static real slope(vec3 n, vec3 d) {
    return dot(n, d) / length(d);
}
static real without(real G, real factor) {
    return G == 0 ? 0 : G / factor;
}
#define geometry(x, n, y, m) without(geometry(x, n, y, m), slope(n, sub(y, x)))
#include "solutions/homework/path.c"
