// Wrong: the colour of the last reflection replaces what was there before it.
// Expect: the albedos of a path are not multiplied
// Stage: path
#include "solutions/homework/raytracer.h"

#define path_light right_path_light
#include "solutions/homework/path.c"
#undef path_light

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    color L = {0, 0, 0};
    for (int bounce = 0; bounce < 12 && bounce < bounces; bounce++) {
        const hit h = nearest(sc, r, NEAR, FAR);
        if (!h.b) return L;
        if (h.b->finish == GLOW) return bounce == 0 && h.front ? h.b->color : L;
        const color C = h.b->color;
        L = add(L, mul(C, lamp_light(sc, h.p, h.n, g)));
        r = (ray){h.p, cosine_direction(h.n, g)};
    }
    return L;
}
