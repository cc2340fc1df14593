// Wrong: directions chosen by the cosine, weighted with the cosine once more. The
// same mean with less noise: the lamp is aimed at, with that factor too.
// Expect: the directions are chosen by the cosine, and weighted by it again
// Stage: path
#include "solutions/homework/raytracer.h"

static real slope(vec3 n, vec3 d) {
    return dot(n, d) / length(d);
}
#define geometry(x, n, y, m) (1 * geometry(x, n, y, m) * slope(n, sub(y, x)))
#define path_light right_path_light
#include "solutions/homework/path.c"
#undef path_light

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    color C = {1, 1, 1}, L = {0, 0, 0};
    for (int bounce = 0; bounce < 30 && bounce < bounces; bounce++) {
        const hit h = nearest(sc, r, NEAR, FAR);
        if (!h.b) return L;
        if (h.b->finish == GLOW) return bounce == 0 && h.front ? h.b->color : L;
        C = mul(C, h.b->color);
        L = add(L, mul(C, lamp_light(sc, h.p, h.n, g)));
        const vec3 v = cosine_direction(h.n, g);
        C = scale(1 * dot(h.n, v), C);
        r = (ray){h.p, v};
    }
    return L;
}
