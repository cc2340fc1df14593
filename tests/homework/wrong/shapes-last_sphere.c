// Wrong: a sphere that is hit covers what was hit before it, near or far.
// Expect: the last sphere hit is seen, not the nearest body
// Stage: depth
#include "solutions/homework/raytracer.h"

#define nearest right_nearest
#include "solutions/homework/shapes.c"
#undef nearest

hit nearest(const scene *sc, ray r, real t_min, real t_max) {
    hit best = {.t = t_max};
    for (int i = 0; i < sc->count; i++) {
        const scene one = {.bodies = &sc->bodies[i], .count = 1};
        const bool is_sphere = one.bodies->shape == SPHERE;
        const hit h = right_nearest(&one, r, t_min, is_sphere ? t_max : best.t);
        if (h.b) best = h;
    }
    return best;
}
