// Wrong: at most five reflections.
// Expect: too few bounces
// Stage: path
#include "solutions/homework/raytracer.h"

#define path_light right_path_light
#include "solutions/homework/path.c"
#undef path_light

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    return right_path_light(sc, r, bounces < 5 ? bounces : 5, g);
}
