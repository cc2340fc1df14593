// Wrong: uniform directions, weighted without the cosine, and the lamp found by them alone. The
// same mean with less noise: the lamp is aimed at, without the cosine too.
// Expect: the cosine at the surface, n·v, is missing at every reflection
// Stage: path
#include "solutions/homework/raytracer.h"

static real slope(vec3 n, vec3 d) {
    return dot(n, d) / length(d);
}
static real without(real G, real factor) {
    return G == 0 ? 0 : G / factor;
}
#define geometry(x, n, y, m) without(geometry(x, n, y, m), slope(n, sub(y, x)))
#define path_light right_path_light
#include "solutions/homework/path.c"
#undef path_light

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    color C = {1, 1, 1}, L = {0, 0, 0};
    for (int bounce = 0; bounce < 12 && bounce < bounces; bounce++) {
        const hit h = nearest(sc, r, NEAR, FAR);
        if (!h.b) return L;
        if (h.b->finish == GLOW) return bounce == 0 && h.front ? h.b->color : L;
        C = mul(C, h.b->color);
        L = add(L, mul(C, lamp_light(sc, h.p, h.n, g)));
        const vec3 v = cosine_direction((vec3){0, 0, 0}, g); // the whole sphere
        C = scale(2, C);
        r = (ray){h.p, dot(h.n, v) < 0 ? neg(v) : v};
    }
    return L;
}
