// glass.c: see glass.h. The derivations are in README.md.
#include "chapters/11-fresnel/glass.h"

int media_now(const media *in, const substance *of) {
    int best = -1;
    for (int i = 0; i < in->count; i++) {
        const int body = in->body[i];
        if (best < 0 || of[body].priority >= of[best].priority) best = body;
    }
    return best;
}

media media_pass(media in, int body, bool inwards) {
    int kept = 0;
    for (int i = 0; i < in.count; i++)
        if (in.body[i] != body) in.body[kept++] = in.body[i];
    in.count = kept;
    if (inwards && in.count < MEDIA_MAX) in.body[in.count++] = body;
    return in;
}

// The index of the medium at hand.
static real index_in(const glass_room *sc, const media *in) {
    const int body = media_now(in, sc->substances);
    return body < 0 ? 1 : sc->substances[body].n;
}

// ---- the walk ----------------------------------------------------------------------

typedef struct {
    ray r;
    color C, L; // what the path still lets through, what it has collected: L / n²
    real p;     // the density of r.d, where the lamps were aimed at too; else 0
    media in;
} walk;

// The path goes on along d, from the side of the hit's surface that `side` points to.
static void set_off(walk *w, hit h, vec3 side, vec3 d, real p) {
    w->r = (ray){offset_origin(h.p, h.error, side, side), d};
    w->p = p;
}

// A boundary of a glass body, as the path meets it.
typedef struct {
    media beyond; // what the path is in behind it
    real eta;     // 1: there is nothing to be seen of it
} boundary;

static boundary boundary_at(const glass_room *sc, const walk *w, int body, hit h) {
    const media beyond = media_pass(w->in, body, h.front);
    return (boundary){beyond, index_in(sc, &beyond) / index_in(sc, &w->in)};
}

static void pass(walk *w, hit h, vec3 d, media beyond) {
    w->in = beyond;
    set_off(w, h, h.front ? neg(h.n) : h.n, d, 0);
}

static void cross_medium(const glass_room *sc, walk *w, real t) {
    const int body = media_now(&w->in, sc->substances);
    if (body >= 0) w->C = mul(w->C, absorb(sc->substances[body].sigma, t));
}

// The next hit that is more than a boundary with nothing to be seen.
static hit next_stop(const glass_room *sc, walk *w, int *body) {
    for (;;) {
        const hit h = scene_nearest(&sc->room.bodies, w->r, 0, NO_HIT, body);
        cross_medium(sc, w, h.t);
        if (h.t == NO_HIT || sc->substances[*body].kind != GLASS) return h;
        const boundary b = boundary_at(sc, w, *body, h);
        if (b.eta != 1) return h;
        pass(w, h, w->r.d, b.beyond);
    }
}

static bool is_black(color c) {
    return c.x <= 0 && c.y <= 0 && c.z <= 0; // NaN is not
}

// What an opaque body shines. Through a boundary L / n² stays the same, not L.
static void collect(const glass_room *sc, walk *w, int body, hit h) {
    const color emittance = sc->room.surfaces[body].emittance;
    if (is_black(emittance) || !h.front || sc->substances[body].kind != OPAQUE) return;
    const real n = index_in(sc, &w->in);
    const real share = w->p > 0 ? share_of_hit(&sc->room, body, w->r, h, w->p) : 1;
    w->L = add(w->L, scale(share / (n * n), mul(w->C, emittance)));
}

// ---- the bounces -------------------------------------------------------------------

// The side that d points to is the side on which the path goes on: so what it is in
// is always where it is.
static void bounce_glass(const glass_room *sc, walk *w, int body, hit h, rng *g) {
    const vec3 n = h.front ? h.n : neg(h.n);
    const boundary b = boundary_at(sc, w, body, h);
    const vec3 d = glass_bounce(w->r.d, n, b.eta, g);
    if (dot(d, n) < 0)
        pass(w, h, d, b.beyond);
    else
        set_off(w, h, n, d, 0);
}

// A metal's index is that in air: what counts is how much it differs from the medium's.
static void bounce_metal(const glass_room *sc, const metal *m, walk *w, hit h) {
    const vec3 n = h.front ? h.n : neg(h.n);
    const real cosine = fmin(fmax(-dot(w->r.d, n), 0), 1), relative = 1 / index_in(sc, &w->in);
    w->C = mul(w->C, fresnel_conductor(cosine, scale(relative, m->eta), scale(relative, m->k)));
    set_off(w, h, n, keep_unit(reflect(w->r.d, n)), 0);
}

// Shadow rays end at glass, so the lamps are aimed at in air only; within glass they
// count in full when they are met.
static void bounce_opaque(const glass_room *sc, walk *w, int body, hit h, int bounce, rng *g) {
    const stop at = stop_at(&sc->room.surfaces[body], w->r, h);
    const bool aims = w->in.count == 0;
    if (aims) w->L = add(w->L, mul(w->C, direct_light(&sc->room, &at, g)));
    const scattered next = surface_scatter(at.m, at.n, at.o, g);
    w->C = next.p > 0 ? mul(w->C, next.weight) : (color){0, 0, 0};
    w->C = scale(roulette(survival(w->C, bounce), g), w->C);
    w->r = (ray){at.start, next.v};
    w->p = aims ? next.p : 0;
}

// Roulette is for opaque surfaces alone: a path in clear glass loses nothing.
static void bounce_off(const glass_room *sc, walk *w, int body, hit h, int bounce, rng *g) {
    switch (sc->substances[body].kind) {
    case OPAQUE:
        bounce_opaque(sc, w, body, h, bounce, g);
        break;
    case GLASS:
        bounce_glass(sc, w, body, h, g);
        break;
    case METAL:
        bounce_metal(sc, sc->substances[body].metal, w, h);
        break;
    }
}

// L / n² of the light that arrives.
static color walk_light(const glass_room *sc, walk *w, int s, rng *g) {
    for (int bounce = 0; !is_black(w->C); bounce++) {
        int body = 0;
        const hit h = next_stop(sc, w, &body);
        if (h.t == NO_HIT) return add(w->L, mul(w->C, sky_light(&sc->room.bodies, w->r.d)));
        collect(sc, w, body, h);
        if (bounce == s) break;
        bounce_off(sc, w, body, h, bounce, g);
    }
    return w->L;
}

// flatten: see light_trace of chapter 10.
__attribute__((flatten)) color glass_trace(const glass_room *sc, ray r, int s, rng *g) {
    walk w = {.r = {r.O, normalize(r.d)}, .C = {1, 1, 1}, .in = sc->start};
    const real n = index_in(sc, &w.in);
    return scale(n * n, walk_light(sc, &w, s, g));
}
