// Wrong: the sign of the cosine.
// Expect: -dot(n, v): the sign of the cosine is wrong
// Expect: minus the reflected light
#include "chapters/09-path-tracer/path.h"

color bounce_ray(const room *sc, const matte *m, ray r, hit h, int s, rng *g) {
    (void)r;
    if (s == 0) return emitted(m, h);
    const vec3 n = h.front ? h.n : neg(h.n);
    const vec3 v = hemisphere_direction(n, g);
    const ray next = {offset_origin(h.p, h.error, n, n), v};
    const color incoming = trace_ray(sc, next, s - 1, g);
    const color reflectance = scale((real)lambert_brdf(1), m->albedo);
    const real probability = (real)(1 / (2 * PI));
    return add(emitted(m, h), scale(-dot(n, v) / probability, mul(reflectance, incoming)));
}
