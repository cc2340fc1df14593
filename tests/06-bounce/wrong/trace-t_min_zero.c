// Wrong: t_min = 0 also where the scene asks for the fixed epsilon.
// Expect: was t_min set for it?
// Expect: See start_t_min
#include "chapters/06-bounce/bounce.h"

color trace(const scene *sc, ray r, int s, rng *g) {
    color C = {1, 1, 1};
    for (;; s--) {
        const material *m = NULL;
        const hit h = scene_hit(sc, r, 0, NO_HIT, &m);
        if (h.t == NO_HIT) return mul(C, sc->sky(r.d));
        if (s == 0) return (color){0, 0, 0};
        C = mul(C, albedo_at(m, h.p));
        r = bounce(sc, m, r, h, g);
    }
}
