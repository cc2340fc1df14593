// Wrong: the sky's light is returned without the colours of the bounces.
// Expect: the light of the sky, unfiltered by the object
#include "chapters/06-bounce/bounce.h"

color trace(const scene *sc, ray r, int s, rng *g) {
    real t_min = 0;
    for (;; s--) {
        const material *m = NULL;
        const hit h = scene_hit(sc, r, t_min, NO_HIT, &m);
        if (h.t == NO_HIT) return sc->sky(r.d);
        if (s == 0) return (color){0, 0, 0};
        r = bounce(sc, m, r, h, g);
        t_min = start_t_min(sc->start);
    }
}
