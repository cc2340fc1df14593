// Wrong: bright samples are cut off, as against fireflies.
// Expect: is light cut off?
#include "chapters/09-path-tracer/path.h"

// C: what the path still lets through, L: what it has collected.
color path_trace(const room *sc, ray r, int s, rng *g) {
    color C = {1, 1, 1}, L = {0, 0, 0};
    for (int bounce = 0;; bounce++) {
        int body = 0;
        const hit h = scene_nearest(&sc->bodies, r, 0, NO_HIT, &body);
        if (h.t == NO_HIT) return add(L, mul(C, sky_light(&sc->bodies, r.d)));
        const matte *m = &sc->surfaces[body];
        const color e = mul(C, emitted(m, h));
        L = add(L, (color){fmin(e.x, 20), fmin(e.y, 20), fmin(e.z, 20)});
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
