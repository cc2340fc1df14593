// Wrong: the lamp's light without the cosine at the lamp.
// Expect: the cosine at the lamp is missing
// Stage: path
#include "solutions/homework/raytracer.h"

static real slope(vec3 n, vec3 d) {
    return dot(n, d) / length(d);
}
static real without(real G, real factor) {
    return G == 0 ? 0 : G / factor;
}
#define geometry(x, n, y, m) without(geometry(x, n, y, m), slope(m, sub(x, y)))
#include "solutions/homework/path.c"
