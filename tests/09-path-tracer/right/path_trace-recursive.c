// Right: the recursion with roulette.
#include "chapters/09-path-tracer/path.h"

static color follow(const room *sc, ray r, color C, int bounce, int s, rng *g) {
    int body = 0;
    const hit h = scene_nearest(&sc->bodies, r, 0, NO_HIT, &body);
    if (h.t == NO_HIT) return mul(C, sky_light(&sc->bodies, r.d));
    const matte *m = &sc->surfaces[body];
    const color L = mul(C, emitted(m, h));
    if (bounce == s) return L;
    const vec3 n = h.front ? h.n : neg(h.n), v = hemisphere_direction(n, g);
    C = scale(2 * dot(n, v), mul(C, m->albedo));
    const real weight = roulette(survival(C, bounce), g);
    const ray next = {offset_origin(h.p, h.error, n, n), v};
    return weight == 0 ? L : add(L, follow(sc, next, scale(weight, C), bounce + 1, s, g));
}

color path_trace(const room *sc, ray r, int s, rng *g) {
    return follow(sc, r, (color){1, 1, 1}, 0, s, g);
}
