// Wrong: nothing is added on a miss.
// Expect: C times the sky on a miss
#include "chapters/09-path-tracer/path.h"

// C: what the path still lets through, L: what it has collected.
color path_trace(const room *sc, ray r, int s, rng *g) {
    color C = {1, 1, 1}, L = {0, 0, 0};
    for (int bounce = 0;; bounce++) {
        int body = 0;
        const hit h = scene_nearest(&sc->bodies, r, 0, NO_HIT, &body);
        if (h.t == NO_HIT) return L;
        const matte *m = &sc->surfaces[body];
        L = add(L, mul(C, emitted(m, h)));
        if (bounce == s) return L;
        const vec3 n = h.front ? h.n : neg(h.n);
        const vec3 v = hemisphere_direction(n, g);
        C = scale(2 * dot(n, v), mul(C, m->albedo)); // rho/π cos θ / (1/(2π))
        const real weight = roulette(survival(C, bounce), g);
        if (weight == 0) return L;
        C = scale(weight, C);
        r = (ray){offset_origin(h.p, h.error, n, n), v};
    }
}
