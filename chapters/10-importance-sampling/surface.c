// surface.c: frames, and how a surface scatters light.
#include "chapters/10-importance-sampling/importance.h"

// copysign keeps the division away from 1 + n.z = 0.
frame orthonormal_basis(vec3 n) {
    const real sign = copysign((real)1, n.z);
    const real a = -1 / (sign + n.z), b = n.x * n.y * a;
    return (frame){
        {1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

vec3 to_local(frame f, vec3 v) {
    return (vec3){dot(v, f.s), dot(v, f.t), dot(v, f.n)};
}

vec3 to_world(frame f, vec3 v) {
    return add(add(scale(v.x, f.s), scale(v.y, f.t)), scale(v.z, f.n));
}

color surface_brdf(const surface *m, vec3 n, vec3 o, vec3 v) {
    if (dot(n, o) <= 0 || dot(n, v) <= 0) return (color){0, 0, 0};
    if (m->lobe == LAMBERT) return scale((real)(1 / PI), m->albedo);
    const frame f = orthonormal_basis(n);
    const real brdf = ggx_brdf(to_local(f, o), to_local(f, v), m->alpha);
    return scale(brdf, schlick_color(m->albedo, dot(o, normalize(add(o, v)))));
}

// A normal h leads to v = -o mirrored in it; dv = 4 (o·h) dh.
real surface_probability(const surface *m, vec3 n, vec3 o, vec3 v) {
    if (m->lobe == LAMBERT) return cosine_probability(n, v);
    if (dot(n, o) <= 0 || dot(n, v) <= 0) return 0;
    const frame f = orthonormal_basis(n);
    const vec3 local = to_local(f, o), h = normalize(add(local, to_local(f, v)));
    return ggx_normal_probability(local, h, m->alpha) / (4 * dot(local, h));
}

static scattered scatter_ggx(const surface *m, vec3 n, vec3 o, rng *g) {
    const frame f = orthonormal_basis(n);
    const vec3 local = to_local(f, o);
    const vec3 h = ggx_normal(local, m->alpha, g);
    const vec3 v = neg(reflect(local, h));
    const real cosine = dot(local, h);
    if (!(v.z > 0) || !(cosine > 0)) return (scattered){.p = 0};
    const real p = ggx_normal_probability(local, h, m->alpha) / (4 * cosine);
    const color F = schlick_color(m->albedo, cosine);
    return (scattered){keep_unit(to_world(f, v)), scale(ggx_weight(local, v, m->alpha), F), p};
}

// Lambert: rho/π cos θ / (cos θ/π) = rho.
scattered surface_scatter(const surface *m, vec3 n, vec3 o, rng *g) {
    if (m->lobe == GGX) return scatter_ggx(m, n, o, g);
    const vec3 v = cosine_direction(n, g);
    return (scattered){v, m->albedo, cosine_probability(n, v)};
}
