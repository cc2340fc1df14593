// Right: the two π cancelled on paper: 2 albedo (n·v).
#include "chapters/09-path-tracer/path.h"

color bounce_ray(const room *sc, const matte *m, ray r, hit h, int s, rng *g) {
    (void)r;
    const color L_e = emitted(m, h);
    if (s == 0) return L_e;
    const vec3 n = h.front ? h.n : neg(h.n), v = hemisphere_direction(n, g);
    const ray next = {offset_origin(h.p, h.error, h.n, v), v};
    return add(L_e, scale(2 * dot(n, v), mul(m->albedo, trace_ray(sc, next, s - 1, g))));
}
