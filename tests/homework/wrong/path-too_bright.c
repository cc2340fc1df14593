// Wrong: 1/π is missing, and the lamp is found by chance: every reflection adds light.
// Expect: far too bright, every reflection adds light: is 1/π missing
// Stage: path
#include "solutions/homework/raytracer.h"

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    color C = {1, 1, 1};
    for (int bounce = 0; bounce <= 12 && bounce <= bounces; bounce++) {
        const hit h = nearest(sc, r, NEAR, FAR);
        if (!h.b) break;
        if (h.b->finish == GLOW) return h.front ? mul(C, h.b->color) : (color){0, 0, 0};
        const vec3 v = cosine_direction((vec3){0, 0, 0}, g); // the whole sphere
        C = scale((real)(2 * PI) * fabs(dot(h.n, v)), mul(C, h.b->color));
        r = (ray){h.p, dot(h.n, v) < 0 ? neg(v) : v};
    }
    return (color){0, 0, 0};
}
