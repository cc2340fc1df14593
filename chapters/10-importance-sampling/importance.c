// importance.c: the path tracer that looks for the lamps. The derivations are in README.md.
#include "chapters/10-importance-sampling/importance.h"

// 1 / (1 + (q/p)²): no square overflows that the weight would need.
real power_heuristic(real p, real q) {
    const real k = q / p;
    return 1 / (1 + k * k);
}

static real heuristic(strategy how, real p, real q) {
    return how == BY_POWER ? power_heuristic(p, q) : balance_heuristic(p, q);
}

// From the hit towards the lamp, both ends off their surfaces.
static bool sees(const scene *sc, const stop *at, const aim *a) {
    const vec3 from = offset_origin(at->h.p, at->h.error, at->n, at->n);
    const vec3 to = offset_origin(a->on.p, a->on.error, a->on.n, a->on.n);
    return !scene_blocked(sc, (ray){from, sub(to, from)}, 1 - 4 * REAL_EPSILON);
}

// The light of one point of one lamp, by way of the hit.
color direct_light(const lit_room *sc, const stop *at, rng *g) {
    const color black = {0, 0, 0};
    const aim a = lamps_aim(&sc->lamps, at->h.p, g);
    if (a.body < 0 || !a.on.front || !(a.p > 0) || !isfinite(a.p)) return black;
    const real cosine = dot(at->n, a.v);
    if (!(cosine > 0)) return black;
    const color f = surface_brdf(at->m, at->n, at->o, a.v);
    if (!(f.x > 0 || f.y > 0 || f.z > 0) || !sees(&sc->bodies, at, &a)) return black;
    const real q = surface_probability(at->m, at->n, at->o, a.v);
    const real share = sc->strategy == BY_LAMPS ? 1 : heuristic(sc->strategy, a.p, q);
    return scale(share * cosine / a.p, mul(f, sc->surfaces[a.body].emittance));
}

// How much of a lamp's light counts when the path runs into it by itself: x is where it
// came from, with the density p.
real share_of_hit(const lit_room *sc, int body, ray r, hit h, real p) {
    if (sc->strategy <= BY_BRDF || sc->lamps.of_body[body] < 0) return 1;
    if (sc->strategy == BY_LAMPS) return 0;
    return heuristic(sc->strategy, p, lamps_probability(&sc->lamps, body, r.O, r.d, h));
}

static scattered scatter_uniform(const surface *m, vec3 n, vec3 o, rng *g) {
    const vec3 v = hemisphere_direction(n, g);
    const real p = (real)(1 / (2 * PI));
    return (scattered){v, scale(dot(n, v) / p, surface_brdf(m, n, o, v)), p};
}

color emitted_by(const surface *m, hit h) {
    return h.front ? m->emittance : (color){0, 0, 0};
}

color light_trace(const lit_room *sc, ray r, int s, rng *g) {
    color C = {1, 1, 1}, L = {0, 0, 0};
    real p = 0;
    r.d = normalize(r.d);
    for (int bounce = 0;; bounce++) {
        int body = 0;
        const hit h = scene_nearest(&sc->bodies, r, 0, NO_HIT, &body);
        if (h.t == NO_HIT) return add(L, mul(C, sky_light(&sc->bodies, r.d)));
        const stop at = {&sc->surfaces[body], h, h.front ? h.n : neg(h.n), neg(r.d)};
        const real share = bounce == 0 ? 1 : share_of_hit(sc, body, r, h, p);
        L = add(L, scale(share, mul(C, emitted_by(at.m, h))));
        if (bounce == s) return L;
        if (sc->strategy >= BY_LAMPS) L = add(L, mul(C, direct_light(sc, &at, g)));
        const scattered next = sc->strategy == BY_UNIFORM
                                   ? scatter_uniform(at.m, at.n, at.o, g)
                                   : surface_scatter(at.m, at.n, at.o, g);
        if (!(next.p > 0)) return L;
        C = mul(C, next.weight);
        const real weight = roulette(survival(C, bounce), g);
        if (weight == 0) return L;
        C = scale(weight, C);
        p = next.p;
        r = (ray){offset_origin(h.p, h.error, at.n, at.n), next.v};
    }
}
