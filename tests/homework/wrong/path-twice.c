// Wrong: the lamp is aimed at, and counts again where a path runs into it.
// Expect: the lamp is counted twice
// Stage: path
#include "solutions/homework/raytracer.h"

#define path_light right_path_light
#include "solutions/homework/path.c"
#undef path_light

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    color C = {1, 1, 1}, L = {0, 0, 0};
    for (int bounce = 0;; bounce++) {
        const hit h = nearest(sc, r, NEAR, FAR);
        if (!h.b) return L;
        if (h.b->finish == GLOW) return h.front ? add(L, mul(C, h.b->color)) : L;
        if (bounce == bounces) return L;
        C = mul(C, h.b->color);
        L = add(L, mul(C, lamp_light(sc, h.p, h.n, g)));
        const real q = survival(C, bounce);
        if (rng_real(g) >= q) return L;
        C = scale(1 / q, C);
        r = (ray){h.p, cosine_direction(h.n, g)};
    }
}
