// Wrong: the weight of the last reflection replaces what was there before it, the directions
// being uniform. The same mean with less noise: the lamp is aimed at.
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
        L = add(L, mul(h.b->color, lamp_light(sc, h.p, h.n, g)));
        const vec3 v = cosine_direction((vec3){0, 0, 0}, g); // the whole sphere
        r = (ray){h.p, dot(h.n, v) < 0 ? neg(v) : v};
    }
    return L;
}
