// path.c: see path.h. The derivations are in README.md.
#include "chapters/09-path-tracer/path.h"

color emitted(const matte *m, hit h) {
    return h.front ? m->emittance : (color){0, 0, 0};
}

color sky_light(const scene *bodies, vec3 d) {
    return bodies->sky ? bodies->sky(d) : (color){0, 0, 0};
}

// ---- as on the slide -------------------------------------------------------------

typedef color (*bounce_rule)(const room *sc, const matte *m, ray r, hit h, int s, rng *g);

static color trace_with(bounce_rule bounced, const room *sc, ray r, int s, rng *g) {
    int body = 0;
    const hit h = scene_nearest(&sc->bodies, r, 0, NO_HIT, &body);
    if (h.t == NO_HIT) return sky_light(&sc->bodies, r.d);
    return bounced(sc, &sc->surfaces[body], r, h, s, g);
}

color trace_ray(const room *sc, ray r, int s, rng *g) {
    return trace_with(bounce_ray, sc, r, s, g);
}

// d is made a unit vector and n is turned towards it; s ends the recursion. The
// slide does none of this, and yet its answer is wrong for the dot product alone.
static color bounce_ray_slide(const room *sc, const matte *m, ray r, hit h, int s, rng *g) {
    if (s == 0) return emitted(m, h);
    const vec3 d = normalize(r.d), n = h.front ? h.n : neg(h.n);
    const vec3 v = hemisphere_direction(n, g);
    const ray next = {offset_origin(h.p, h.error, n, n), v};
    const color incoming = trace_ray_slide(sc, next, s - 1, g);
    const color reflectance = scale((real)lambert_brdf(1), m->albedo);
    const real probability = (real)(1 / (2 * PI));
    return add(emitted(m, h), scale(dot(d, v) / probability, mul(reflectance, incoming)));
}

color trace_ray_slide(const room *sc, ray r, int s, rng *g) {
    return trace_with(bounce_ray_slide, sc, r, s, g);
}

// ---- the end of a path -----------------------------------------------------------

enum { SURE_BOUNCES = 3 };           // they carry most of the light
static const real most = (real)0.95; // so that any path ends, after 20 more in the mean

// Comparisons, not fmax and fmin, which are calls and cost more than all the rest of it.
// By size, so that a negative weight, which is a mistake, is not hidden.
real survival(color C, int bounce) {
    const vec3 size = absolute(C);
    real largest = size.x > size.y ? size.x : size.y;
    if (size.z > largest) largest = size.z;
    if (bounce < SURE_BOUNCES) return largest == 0 ? 0 : 1;
    return largest < most ? largest : most;
}
