// Wrong: so noisy that nothing can be said: one path in five hundred brings all the light.
// Expect: too noisy to judge
// Stage: path
#include "solutions/homework/raytracer.h"

#define path_light right_path_light
#include "solutions/homework/path.c"
#undef path_light

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    if (rng_real(g) >= (real)0.002) return (color){0, 0, 0};
    return scale(500, right_path_light(sc, r, bounces, g));
}
