// Right: the loop as a recursion.
#include "chapters/06-bounce/bounce.h"

static color follow(const scene *sc, ray r, real t_min, int s, rng *g) {
    const material *m = NULL;
    const hit h = scene_hit(sc, r, t_min, NO_HIT, &m);
    if (h.t == NO_HIT) return sc->sky(r.d);
    if (s == 0) return (color){0, 0, 0};
    const ray next = bounce(sc, m, r, h, g);
    return mul(albedo_at(m, h.p), follow(sc, next, start_t_min(sc->start), s - 1, g));
}

color trace(const scene *sc, ray r, int s, rng *g) {
    return follow(sc, r, 0, s, g);
}
