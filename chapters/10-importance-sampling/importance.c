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

// NaN is not black: what is wrong must reach the picture, where it is counted.
static bool is_black(color c) {
    return c.x == 0 && c.y == 0 && c.z == 0;
}

stop stop_at(const surface *m, ray r, hit h) {
    const vec3 n = h.front ? h.n : neg(h.n);
    return (stop){m, n, neg(r.d), offset_origin(h.p, h.error, n, n)};
}

// ---- the light of the lamps ----------------------------------------------------------

static bool sees(const lit_room *sc, const stop *at, const aim *a) {
    const ray r = {at->start, sub(a->end, at->start)};
    return !scene_blocked(&sc->bodies, r, 1 - 4 * REAL_EPSILON, a->except);
}

color direct_light(const lit_room *sc, const stop *at, rng *g) {
    const color black = {0, 0, 0};
    if (sc->strategy < BY_LAMPS) return black;
    const aim a = lamps_aim(&sc->lamps, at->start, g);
    if (a.body < 0 || !a.on.front) return black;
    const color f = surface_brdf(at->m, at->n, at->o, a.v);
    if (is_black(f) || !sees(sc, at, &a)) return black;
    const real p = lamps_probability(&sc->lamps, a.body, at->start, a.on);
    if (!(p > 0) || !isfinite(p)) return black;
    const real q = surface_probability(at->m, at->n, at->o, a.v);
    const real share = sc->strategy == BY_LAMPS ? 1 : heuristic(sc->strategy, p, q);
    return scale(share * dot(at->n, a.v) / p, mul(f, sc->surfaces[a.body].emittance));
}

real share_of_hit(const lit_room *sc, int body, ray r, hit h, real p) {
    if (sc->strategy < BY_LAMPS || sc->lamps.of_body[body] < 0) return 1;
    if (sc->strategy == BY_LAMPS) return 0;
    return heuristic(sc->strategy, p, lamps_probability(&sc->lamps, body, r.O, h));
}

// ---- the path ------------------------------------------------------------------------

static color shine(const surface *m, hit h) {
    return h.front ? m->emittance : (color){0, 0, 0};
}

static scattered scatter_uniform(const stop *at, rng *g) {
    const vec3 v = hemisphere_direction(at->n, g);
    const real p = (real)(1 / (2 * PI));
    const color f = surface_brdf(at->m, at->n, at->o, v);
    return (scattered){v, scale(dot(at->n, v) / p, f), p};
}

// C: what the path still lets through, L: what it has collected, p: the density with which
// its last direction was chosen. flatten: with -flto all that it calls is compiled into it, and
// no ray or hit goes through memory.
__attribute__((flatten)) color light_trace(const lit_room *sc, ray r, int s, rng *g) {
    color C = {1, 1, 1}, L = {0, 0, 0};
    real p = 0;
    r.d = normalize(r.d);
    for (int bounce = 0;; bounce++) {
        int body = 0;
        const hit h = scene_nearest(&sc->bodies, r, 0, NO_HIT, &body);
        if (h.t == NO_HIT) return add(L, mul(C, sky_light(&sc->bodies, r.d)));
        const stop at = stop_at(&sc->surfaces[body], r, h);
        const real share = bounce == 0 ? 1 : share_of_hit(sc, body, r, h, p);
        L = add(L, scale(share, mul(C, shine(at.m, h))));
        if (bounce == s) return L;
        L = add(L, mul(C, direct_light(sc, &at, g)));
        const scattered next = sc->strategy == BY_UNIFORM
                                   ? scatter_uniform(&at, g)
                                   : surface_scatter(at.m, at.n, at.o, g);
        if (!(next.p > 0)) return L;
        C = mul(C, next.weight);
        if (is_black(C)) return L;
        const real weight = roulette(survival(C, bounce), g);
        if (weight == 0) return L;
        C = scale(weight, C);
        p = next.p;
        r = (ray){at.start, next.v};
    }
}
