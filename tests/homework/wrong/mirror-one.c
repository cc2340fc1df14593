// Wrong: one reflection and no more.
// Expect: one reflection and no more
// Stage: mirror
#include "solutions/homework/raytracer.h"

#define mirror_light right_mirror_light
#include "solutions/homework/mirror.c"
#undef mirror_light

color mirror_light(const scene *sc, ray r, int bounces, rng *g) {
    return right_mirror_light(sc, r, bounces < 1 ? bounces : 1, g);
}
