// Wrong: an odd number is taken for one whose % 2 is 1: of a negative one it is -1.
// Expect: -1 % 2 is -1, not 1
// Stage: mirror
#include "solutions/homework/raytracer.h"

#define mirror_light right_mirror_light
#include "solutions/homework/mirror.c"
#undef mirror_light

color mirror_light(const scene *sc, ray r, int bounces, rng *g) {
    const hit h = nearest(sc, r, NEAR, FAR);
    if (!h.b || bounces == 0) return right_mirror_light(sc, r, bounces, g);
    if (h.b->checkered && ((int)floor(h.p.x) + (int)floor(h.p.z)) % 2 != 1) return h.b->color;
    if (h.b->finish == GLOW) return right_mirror_light(sc, r, bounces, g);
    const ray mirrored = {h.p, sub(r.d, scale(2 * dot(r.d, h.n), h.n))};
    return mul(h.b->color, mirror_light(sc, mirrored, bounces - 1, g));
}
