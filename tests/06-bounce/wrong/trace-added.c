// Wrong: the sky's light is added to C.
// Expect: 1 + albedo: added (add), not multiplied (mul)
// Expect: 1 + the sky: added (add), not multiplied (mul)
#include "chapters/06-bounce/bounce.h"

color trace(const scene *sc, ray r, int s, rng *g) {
    color C = {1, 1, 1};
    real t_min = 0;
    for (;; s--) {
        const material *m = NULL;
        const hit h = scene_hit(sc, r, t_min, NO_HIT, &m);
        if (h.t == NO_HIT) return add(C, sc->sky(r.d));
        if (s == 0) return (color){0, 0, 0};
        C = mul(C, albedo_at(m, h.p));
        r = bounce(sc, m, r, h, g);
        t_min = start_t_min(sc->start);
    }
}
