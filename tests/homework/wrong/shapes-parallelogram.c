// Wrong: the triangle is hit where neither u nor w is above 1.
// Expect: the triangle is a parallelogram
// Stage: depth
#include "solutions/homework/raytracer.h"

#define nearest right_nearest
#include "solutions/homework/shapes.c"
#undef nearest

// The nearest of the scene's bodies and of the parallelogram's other half.
hit nearest(const scene *sc, ray r, real t_min, real t_max) {
    hit h = right_nearest(sc, r, t_min, t_max);
    for (int i = 0; i < sc->count; i++) {
        body half = sc->bodies[i];
        if (half.shape != TRIANGLE) continue;
        const vec3 a = half.p[0], b = half.p[1], c = half.p[2];
        half.p[0] = c, half.p[1] = b, half.p[2] = add(b, sub(c, a));
        const scene one = {.bodies = &half, .count = 1};
        const hit other = right_nearest(&one, r, t_min, h.t);
        if (other.b) h = other, h.b = &sc->bodies[i];
    }
    return h;
}
