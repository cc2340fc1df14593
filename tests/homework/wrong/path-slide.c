// Wrong: dot(d, v), as on the slide: the light is negative.
// Expect: is dot(d, v) where n·v is meant
// Stage: path
#include "solutions/homework/raytracer.h"

#define path_light right_path_light
#include "solutions/homework/path.c"
#undef path_light

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    const hit h = nearest(sc, r, NEAR, FAR);
    if (!h.b || bounces == 0) return (color){0, 0, 0};
    if (h.b->finish == GLOW) return h.front ? h.b->color : (color){0, 0, 0};
    const vec3 v = cosine_direction(h.n, g);
    const color light = path_light(sc, (ray){h.p, v}, bounces - 1, g);
    return scale(dot(r.d, v) / dot(h.n, v), mul(h.b->color, light));
}
