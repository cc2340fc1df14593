// Wrong: one reflection and no more.
// Expect: direct light alone
// Stage: path
#include "solutions/homework/raytracer.h"

#define path_light right_path_light
#include "solutions/homework/path.c"
#undef path_light

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    return right_path_light(sc, r, bounces < 1 ? bounces : 1, g);
}
