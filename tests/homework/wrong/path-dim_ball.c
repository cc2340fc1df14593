// Wrong: the small ball is 10 % too dark.
// Expect: only the yellow ball is wrong
// Expect: the yellow ball: 1
// Stage: path
#include "solutions/homework/raytracer.h"

#define path_light right_path_light
#include "solutions/homework/path.c"
#undef path_light

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    const hit h = nearest(sc, r, NEAR, FAR);
    const bool small = h.b && h.b->shape == SPHERE && h.b->r < (real)0.4;
    return scale(small ? (real)0.9 : 1, right_path_light(sc, r, bounces, g));
}
