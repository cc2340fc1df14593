// Wrong: s is never looked at nor counted down.
// Expect: endless
// Expect: a bounce is made although s is 0
#include "chapters/09-path-tracer/path.h"

color bounce_ray(const room *sc, const matte *m, ray r, hit h, int s, rng *g) {
    (void)r;
    const vec3 n = h.front ? h.n : neg(h.n);
    const vec3 v = hemisphere_direction(n, g);
    const ray next = {offset_origin(h.p, h.error, n, n), v};
    const color incoming = trace_ray(sc, next, s, g);
    const color reflectance = scale((real)lambert_brdf(1), m->albedo);
    const real probability = (real)(1 / (2 * PI));
    return add(emitted(m, h), scale(dot(n, v) / probability, mul(reflectance, incoming)));
}
