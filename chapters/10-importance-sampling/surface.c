// surface.c: how a surface scatters light.
#include "chapters/10-importance-sampling/importance.h"

static bool above(vec3 n, vec3 o, vec3 v) {
    return dot(n, o) > 0 && dot(n, v) > 0;
}

// h is half way between the unit vectors o and v, so |o + v| = 2 (o·h).
color surface_brdf(const surface *m, vec3 n, vec3 o, vec3 v) {
    if (!above(n, o, v)) return (color){0, 0, 0};
    if (m->lobe == LAMBERT) return scale((real)(1 / PI), m->albedo);
    const frame f = orthonormal_basis(n);
    const real f_r = ggx_brdf(to_local(f, o), to_local(f, v), m->alpha);
    return scale(f_r, schlick_color(m->albedo, length(add(o, v)) / 2));
}

// v is o mirrored in the normal h: turning h by an angle turns v by twice that, and the solid
// angle dv is 4 (o·h) dh.
static real mirrored_probability(vec3 o, vec3 h, real alpha) {
    return ggx_normal_probability(o, h, alpha) / (4 * dot(o, h));
}

real surface_probability(const surface *m, vec3 n, vec3 o, vec3 v) {
    if (m->lobe == LAMBERT) return cosine_probability(n, v);
    if (!above(n, o, v)) return 0;
    const frame f = orthonormal_basis(n);
    const vec3 local = to_local(f, o), h = normalize(add(local, to_local(f, v)));
    return dot(local, h) > 0 ? mirrored_probability(local, h, m->alpha) : 0;
}

static scattered scatter_ggx(const surface *m, vec3 n, vec3 o, rng *g) {
    const frame f = orthonormal_basis(n);
    const vec3 local = to_local(f, o), h = ggx_normal(local, m->alpha, g);
    const vec3 mirrored = neg(reflect(local, h)), v = keep_unit(to_world(f, mirrored));
    const real cosine = dot(local, h);
    if (!(cosine > 0) || !above(n, o, v)) return (scattered){.p = 0};
    const color F = schlick_color(m->albedo, cosine);
    const color weight = scale(ggx_weight(local, mirrored, m->alpha), F);
    return (scattered){v, weight, mirrored_probability(local, h, m->alpha)};
}

// Lambert: rho/π cos θ / (cos θ/π) = rho.
scattered surface_scatter(const surface *m, vec3 n, vec3 o, rng *g) {
    if (m->lobe == GGX) return scatter_ggx(m, n, o, g);
    const vec3 v = cosine_direction(n, g);
    return (scattered){v, m->albedo, cosine_probability(n, v)};
}
