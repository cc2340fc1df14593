// Right: directions by the cosine, whose weight is the albedo: the same mean, less noise.
#include "chapters/09-path-tracer/path.h"

color bounce_ray(const room *sc, const matte *m, ray r, hit h, int s, rng *g) {
    (void)r;
    if (s == 0) return emitted(m, h);
    const vec3 n = h.front ? h.n : neg(h.n);
    const ray next = {offset_origin(h.p, h.error, n, n), matte_bounce(n, g)};
    return add(emitted(m, h), mul(m->albedo, trace_ray(sc, next, s - 1, g)));
}
