// plain.h: the box with a ball of gold and one of glass, by a path tracer in plain doubles: see
// chapter 10's. measure.c puts it beside glass_trace.
#ifndef CHAPTER_FRESNEL_PLAIN_H
#define CHAPTER_FRESNEL_PLAIN_H

#include "chapters/10-importance-sampling/plain.h"
#include "chapters/11-fresnel/glass.h"

typedef struct {
    plain_box box;
    double n;   // of the glass
    vec eta, k; // of the metal
} plain_glass;

static double plain_dielectric(double c, double eta) {
    const double sin2 = (1 - c * c) / (eta * eta);
    if (sin2 >= 1) return 1;
    const double b = eta * sqrt(1 - sin2), Rs = (c - b) / (c + b),
                 Rp = (eta * eta * c - b) / (eta * eta * c + b);
    return (Rs * Rs + Rp * Rp) / 2;
}

static double plain_conductor(double c, double eta, double k) {
    const double sin2 = 1 - c * c, re = eta * eta - k * k - sin2,
                 sum = sqrt(re * re + 4 * eta * eta * k * k), a = sqrt((sum + re) / 2);
    const double u = sum + c * c, v = 2 * a * c, Rs = (u - v) / (u + v);
    const double p = c * c * sum + sin2 * sin2, q = v * sin2;
    return Rs * (1 + (p - q) / (p + q)) / 2;
}

static vec plain_gold(const plain_glass *b, double c) {
    return (vec){plain_conductor(c, b->eta.x, b->k.x), plain_conductor(c, b->eta.y, b->k.y),
                 plain_conductor(c, b->eta.z, b->k.z)};
}

static vec plain_mirror(vec d, vec n) {
    return vec_sub(d, vec_scale(2 * wide_dot(d, n), n));
}

// c: the cosine of the ray's angle. Through the surface, *inside changes.
static vec plain_refract(double n_glass, vec d, vec n, double c, bool *inside, rng *g) {
    const double eta = *inside ? 1 / n_glass : n_glass;
    if (rng_real(g) < plain_dielectric(c, eta)) return plain_mirror(d, n);
    *inside = !*inside;
    const double cos_t = sqrt(1 - (1 - c * c) / (eta * eta));
    return vec_add(vec_scale(1 / eta, d), vec_scale(c / eta - cos_t, n));
}

__attribute__((flatten)) static vec plain_glass_trace(const plain_glass *b, vec O, vec d, int s,
                                                      rng *g) {
    vec C = {1, 1, 1}, L = {0, 0, 0};
    double p = 0; // 0: the lamp was not aimed at
    bool inside = false;
    for (int bounce = 0;; bounce++) {
        double t;
        const int body = plain_nearest(&b->box, O, d, &t);
        if (body < 0) return L;
        O = vec_add(O, vec_scale(t, d));
        vec n = plain_normal(&b->box, body, O);
        const bool front = wide_dot(n, d) < 0;
        if (body == LAMP && front)
            L = vec_add(L, vec_scale(p > 0 ? plain_share(&b->box, d, t, p) : 1,
                                     vec_mul(C, b->box.emittance)));
        if (!front) n = vec_scale(-1, n);
        if (bounce == s) return L;
        const double c = -wide_dot(d, n);
        p = 0;
        if (body == BALL_LEFT) {
            C = vec_mul(C, plain_gold(b, c));
            d = plain_mirror(d, n);
        } else if (body == BALL_RIGHT) {
            d = plain_refract(b->n, d, n, c, &inside, g);
        } else {
            L = vec_add(L, vec_mul(C, plain_direct(&b->box, O, n, b->box.albedo[body], g)));
            d = plain_cosine(n, g);
            p = wide_dot(n, d) / PI;
            C = vec_mul(C, b->box.albedo[body]);
            if (!plain_goes_on(&C, bounce, g)) return L;
        }
    }
}

// ---- beside the course's -----------------------------------------------------------------

enum { PLAIN_DEPTH = 32 };

typedef struct {
    glass_room room;
    plain_glass plain;
    camera cam;
} gold_and_glass;

static double by_course(const void *data, int i) {
    const gold_and_glass *b = data;
    rng g = rng_seed(1, (uint64_t)i);
    return (double)glass_trace(&b->room, plain_ray(&b->cam, i, &g), PLAIN_DEPTH, &g).y;
}

static double by_plain(const void *data, int i) {
    const gold_and_glass *b = data;
    rng g = rng_seed(2, (uint64_t)i);
    const ray r = plain_ray(&b->cam, i, &g);
    return plain_glass_trace(&b->plain, widen(r.O), wide_unit(widen(r.d)), PLAIN_DEPTH, &g).y;
}

static void measure_beside_plain(void) {
    surface surfaces[BOX_BODIES];
    const metal *gold = &metals[0];
    const substance of[BOX_BODIES] = {
        [BALL_LEFT] = {.kind = METAL, .metal = gold},
        [BALL_RIGHT] = {.kind = GLASS, .n = (real)1.5},
    };
    fill_box_surfaces(surfaces, 0);
    gold_and_glass b = {
        {lit(box_bodies, surfaces, BY_POWER), of, {0}},
        {plain_build(&box_bodies, surfaces), 1.5, widen(gold->eta), widen(gold->k)},
        box_camera(PLAIN_SIDE, PLAIN_SIDE)};
    plain_measure("glass_trace", by_course, by_plain, &b);
    lit_free(&b.room.room);
}

#endif
