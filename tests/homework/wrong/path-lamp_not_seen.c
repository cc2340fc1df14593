// Wrong: what the camera's own ray meets does not shine.
// Expect: the lamp itself is not seen
// Stage: path
#include "solutions/homework/raytracer.h"

#define path_light right_path_light
#include "solutions/homework/path.c"
#undef path_light

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    const hit h = nearest(sc, r, NEAR, FAR);
    if (h.b && h.b->finish == GLOW) return (color){0, 0, 0};
    return right_path_light(sc, r, bounces, g);
}
