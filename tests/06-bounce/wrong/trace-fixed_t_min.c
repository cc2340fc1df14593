// Wrong: a fixed t_min for every ray, the first included.
// Expect: t_min of the next rays was used for the first
// Expect: the sky behind the sphere
#include "chapters/06-bounce/bounce.h"

color trace(const scene *sc, ray r, int s, rng *g) {
    color C = {1, 1, 1};
    for (;; s--) {
        const material *m = NULL;
        const hit h = scene_hit(sc, r, (real)1e-4, NO_HIT, &m);
        if (h.t == NO_HIT) return mul(C, sc->sky(r.d));
        if (s == 0) return (color){0, 0, 0};
        C = mul(C, albedo_at(m, h.p));
        r = bounce(sc, m, r, h, g);
    }
}
