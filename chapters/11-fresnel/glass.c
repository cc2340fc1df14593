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

static real index_of(const glass_room *sc, int medium) {
    return medium < 0 ? 1 : sc->substances[medium].n;
}

// ---- the walk ----------------------------------------------------------------------

typedef struct {
    ray r;
    color C, L; // what the path still lets through, what it has collected
    real p;     // the density of r.d; 0: there was no choice, or it was not by a density
    media in;
} walk;

static void set_off(walk *w, hit h, vec3 side, vec3 d) {
    w->r = (ray){offset_origin(h.p, h.error, side, side), d};
}

// The boundary of a glass body, from the side that the path is on.
typedef struct {
    media beyond;    // what the path is in behind it
    int here, there; // the media of both sides, as media_now has them
} boundary;

static boundary boundary_at(const glass_room *sc, const walk *w, int body, hit h) {
    const media beyond = media_pass(w->in, body, h.front);
    return (boundary){beyond, media_now(&w->in, sc->substances),
                      media_now(&beyond, sc->substances)};
}

static void pass(walk *w, hit h, vec3 d, media in) {
    w->in = in;
    set_off(w, h, h.front ? neg(h.n) : h.n, d);
}

static void bounce_glass(const glass_room *sc, walk *w, hit h, boundary b, rng *g) {
    const vec3 n = h.front ? h.n : neg(h.n);
    const vec3 d = glass_bounce(w->r.d, n, index_of(sc, b.there) / index_of(sc, b.here), g);
    w->p = 0;
    if (dot(d, n) < 0)
        pass(w, h, d, b.beyond);
    else
        set_off(w, h, n, d);
}

static void mirror_metal(const metal *m, walk *w, hit h) {
    const vec3 n = h.front ? h.n : neg(h.n);
    w->C = mul(w->C, fresnel_conductor(-dot(w->r.d, n), m->eta, m->k));
    w->p = 0;
    set_off(w, h, n, keep_unit(reflect(w->r.d, n)));
}

// Shadow rays end at glass, so lamps are aimed at in air only; within glass they count
// in full when they are met. False: the path ends.
static bool bounce_opaque(const glass_room *sc, walk *w, int body, hit h, rng *g) {
    const vec3 n = h.front ? h.n : neg(h.n);
    const stop at = {&sc->room.surfaces[body], h, n, neg(w->r.d)};
    const bool aims = w->in.count == 0;
    if (aims) w->L = add(w->L, mul(w->C, direct_light(&sc->room, &at, g)));
    const scattered next = surface_scatter(at.m, n, at.o, g);
    if (!(next.p > 0)) return false;
    w->C = mul(w->C, next.weight);
    w->p = aims ? next.p : 0;
    set_off(w, h, n, next.v);
    return true;
}

// What the hit body shines, seen through the medium at hand: L / n² is what stays the same
// through a boundary, not L.
static void collect(const glass_room *sc, walk *w, int body, hit h) {
    const real n = index_of(sc, media_now(&w->in, sc->substances));
    const real share = w->p > 0 ? share_of_hit(&sc->room, body, w->r, h, w->p) : 1;
    const color L = emitted_by(&sc->room.surfaces[body], h);
    w->L = add(w->L, scale(share / (n * n), mul(w->C, L)));
}

static void cross_medium(const glass_room *sc, walk *w, real t) {
    const int medium = media_now(&w->in, sc->substances);
    if (medium >= 0) w->C = mul(w->C, absorb(sc->substances[medium].sigma, t));
}

// Without the cap of chapter 09: a path in clear glass loses nothing, and goes on.
static bool goes_on(walk *w, const substance *of, int bounce, rng *g) {
    const real largest = fmax(w->C.x, fmax(w->C.y, w->C.z));
    const real q = of->kind == OPAQUE ? survival(w->C, bounce) : fmin(largest, 1);
    if (!(q > 0)) return false;
    const real weight = roulette(q, g);
    w->C = scale(weight, w->C);
    return weight > 0;
}

color glass_trace(const glass_room *sc, ray r, int s, rng *g) {
    walk w = {.r = {r.O, normalize(r.d)}, .C = {1, 1, 1}};
    for (int bounce = 0;;) {
        int body = 0;
        const hit h = scene_nearest(&sc->room.bodies, w.r, 0, NO_HIT, &body);
        cross_medium(sc, &w, h.t);
        if (h.t == NO_HIT) return add(w.L, mul(w.C, sky_light(&sc->room.bodies, w.r.d)));
        const substance *of = &sc->substances[body];
        boundary b = {.here = -1, .there = -1};
        if (of->kind == GLASS) {
            b = boundary_at(sc, &w, body, h);
            if (b.here == b.there) {
                pass(&w, h, w.r.d, b.beyond);
                continue;
            }
        }
        collect(sc, &w, body, h);
        if (bounce == s) return w.L;
        if (of->kind == GLASS)
            bounce_glass(sc, &w, h, b, g);
        else if (of->kind == METAL)
            mirror_metal(of->metal, &w, h);
        else if (!bounce_opaque(sc, &w, body, h, g))
            return w.L;
        if (!goes_on(&w, of, bounce++, g)) return w.L;
    }
}
