// Wrong: directions uniform, weighted as if chosen by the cosine, and the lamp found by them
// alone. The same mean with less noise: the lamp is aimed at, with 1/(2π) for cos θ / π.
// Expect: the directions are uniform, but weighted as if chosen by the cosine
// Stage: path
#include "solutions/homework/raytracer.h"

static vec3 uniform_direction(vec3 n, rng *g) {
    const vec3 v = cosine_direction((vec3){0, 0, 0}, g); // the whole sphere
    return dot(n, v) < 0 ? neg(v) : v;
}
static real slope(vec3 n, vec3 d) {
    return dot(n, d) / length(d);
}
static real without(real G, real factor) {
    return G == 0 ? 0 : G / factor;
}
#define cosine_direction(n, g) uniform_direction(n, g)
#define geometry(x, n, y, m) without(geometry(x, n, y, m), 2 * slope(n, sub(y, x)))
#include "solutions/homework/path.c"
