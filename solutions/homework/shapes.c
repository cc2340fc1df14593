// shapes.c: where a ray meets a sphere, a plane, a triangle; the nearest of all.
#include "solutions/homework/raytracer.h"

#define MISSED ((real)-1)

// The smallest root of a t² + b t + c in (t_min, t_max).
static real sphere_t(const body *S, ray r, real t_min, real t_max) {
    const vec3 v = sub(r.O, S->p[0]);
    const real a = dot(r.d, r.d), b = 2 * dot(v, r.d), c = dot(v, v) - S->r * S->r;
    const real D = b * b - 4 * a * c;
    if (D < 0) return MISSED;
    const real t0 = (-b - sqrt(D)) / (2 * a), t1 = (-b + sqrt(D)) / (2 * a);
    const real t = t0 > t_min ? t0 : t1;
    return t > t_min && t < t_max ? t : MISSED;
}

static real plane_t(vec3 p, vec3 n, ray r, real t_min, real t_max) {
    const real slope = dot(r.d, n);
    if (slope == 0) return MISSED;
    const real t = dot(sub(p, r.O), n) / slope;
    return t > t_min && t < t_max ? t : MISSED;
}

// Not unit.
static vec3 triangle_normal(const body *T) {
    return cross(sub(T->p[1], T->p[0]), sub(T->p[2], T->p[0]));
}

static real triangle_t(const body *T, ray r, real t_min, real t_max) {
    const vec3 n = triangle_normal(T);
    const real t = plane_t(T->p[0], n, r, t_min, t_max);
    if (t == MISSED) return MISSED;
    const vec3 q = add(r.O, scale(t, r.d));
    for (int i = 0; i < 3; i++) { // to the left of every edge
        const vec3 from = T->p[i], to = T->p[(i + 1) % 3];
        if (dot(cross(sub(to, from), sub(q, from)), n) < 0) return MISSED;
    }
    return t;
}

static real body_t(const body *b, ray r, real t_min, real t_max) {
    if (b->shape == SPHERE) return sphere_t(b, r, t_min, t_max);
    if (b->shape == PLANE) return plane_t(b->p[0], b->n, r, t_min, t_max);
    return triangle_t(b, r, t_min, t_max);
}

static vec3 outwards(const body *b, vec3 p) {
    if (b->shape == SPHERE) return normalize(sub(p, b->p[0]));
    if (b->shape == PLANE) return b->n;
    return normalize(triangle_normal(b));
}

hit nearest(const scene *sc, ray r, real t_min, real t_max) {
    hit h = {.t = t_max};
    for (int i = 0; i < sc->count; i++) {
        const real t = body_t(&sc->bodies[i], r, t_min, h.t);
        if (t != MISSED) h.t = t, h.b = &sc->bodies[i];
    }
    if (!h.b) return h;
    h.p = add(r.O, scale(h.t, r.d));
    h.n = outwards(h.b, h.p);
    h.front = dot(h.n, r.d) < 0;
    if (!h.front) h.n = neg(h.n);
    return h;
}

bool blocked(const scene *sc, vec3 x, vec3 y) {
    const ray r = {x, sub(y, x)};
    for (int i = 0; i < sc->count; i++)
        if (body_t(&sc->bodies[i], r, NEAR, 1 - NEAR) != MISSED) return true;
    return false;
}

real geometry(vec3 x, vec3 n, vec3 y, vec3 m) {
    const vec3 d = sub(y, x);
    const real at_x = dot(n, d), at_y = -dot(m, d), square = dot(d, d);
    if (at_x <= 0 || at_y <= 0) return 0;
    return at_x * at_y / (square * square);
}
