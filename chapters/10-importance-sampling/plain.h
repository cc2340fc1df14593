// plain.h: the box by a path tracer as one writes it in an afternoon: doubles, spheres by
// b² - c, triangles by Möller and Trumbore, hits from t = 1e-6 on, no bounds on any error,
// and no scene of another kind. Beside it measure.c asks what the care of the course costs.
#ifndef CHAPTER_IMPORTANCE_PLAIN_H
#define CHAPTER_IMPORTANCE_PLAIN_H

#include "chapters/10-importance-sampling/scenes.h"
#include "common/die.h"
#include "common/wide3.h"

typedef wide3 vec; // all of it is double

static inline vec vec_add(vec a, vec b) {
    return (vec){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline vec vec_sub(vec a, vec b) {
    return (vec){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline vec vec_mul(vec a, vec b) {
    return (vec){a.x * b.x, a.y * b.y, a.z * b.z};
}

static inline vec vec_scale(double s, vec a) {
    return (vec){s * a.x, s * a.y, s * a.z};
}

// ---- the scene -----------------------------------------------------------------------

typedef struct {
    int balls, walls, halves;
    struct {
        vec c;
        double r;
    } ball[WALL_LEFT];
    struct {
        vec x, n;
    } wall[LAMP - WALL_LEFT];
    struct {
        vec p, e, f; // a corner and the edges from it
    } half[2];
    vec lamp_n, emittance, albedo[BOX_BODIES];
    double lamp_area;
} plain_box;

static inline plain_box plain_build(const scene *s, const surface *surfaces) {
    plain_box b = {.balls = s->sphere_count,
                   .walls = s->plane_count,
                   .halves = s->meshes->count,
                   .emittance = widen(surfaces[LAMP].emittance)};
    for (int i = 0; i < BOX_BODIES; i++) b.albedo[i] = widen(surfaces[i].albedo);
    for (int i = 0; i < b.balls; i++)
        b.ball[i].c = widen(s->spheres[i].c), b.ball[i].r = s->spheres[i].r;
    for (int i = 0; i < b.walls; i++)
        b.wall[i].x = widen(s->planes[i].x), b.wall[i].n = widen(s->planes[i].n);
    for (int i = 0; i < b.halves; i++) {
        const triangle T = mesh_triangle(s->meshes, i);
        b.half[i].p = widen(T.p1);
        b.half[i].e = wide_sub(T.p2, T.p1), b.half[i].f = wide_sub(T.p3, T.p1);
        const vec n = wide_cross(b.half[i].e, b.half[i].f);
        b.lamp_area += sqrt(wide_dot(n, n)) / 2;
        b.lamp_n = wide_unit(n);
    }
    return b;
}

// ---- hits ----------------------------------------------------------------------------

static const double plain_epsilon = 1e-6, plain_miss = 1e30;

static inline double plain_ball(const plain_box *b, int i, vec O, vec d) {
    const vec v = vec_sub(b->ball[i].c, O);
    const double half_b = wide_dot(v, d), r = b->ball[i].r;
    const double q = half_b * half_b - wide_dot(v, v) + r * r;
    if (q < 0) return plain_miss;
    const double s = sqrt(q);
    if (half_b - s > plain_epsilon) return half_b - s;
    return half_b + s > plain_epsilon ? half_b + s : plain_miss;
}

static inline double plain_wall(const plain_box *b, int i, vec O, vec d) {
    const double along = wide_dot(b->wall[i].n, d);
    if (along == 0) return plain_miss;
    const double t = wide_dot(vec_sub(b->wall[i].x, O), b->wall[i].n) / along;
    return t > plain_epsilon ? t : plain_miss;
}

static inline double plain_half(const plain_box *b, int i, vec O, vec d) {
    const vec e = b->half[i].e, f = b->half[i].f, p = wide_cross(d, f);
    const double det = wide_dot(e, p);
    if (det == 0) return plain_miss;
    const vec w = vec_sub(O, b->half[i].p);
    const double u = wide_dot(w, p) / det;
    if (u < 0 || u > 1) return plain_miss;
    const vec q = wide_cross(w, e);
    const double v = wide_dot(d, q) / det;
    if (v < 0 || u + v > 1) return plain_miss;
    const double t = wide_dot(f, q) / det;
    return t > plain_epsilon ? t : plain_miss;
}

// The number of the body, as in box.h.
static inline int plain_nearest(const plain_box *b, vec O, vec d, double *nearest) {
    int body = -1;
    double best = plain_miss, t;
    for (int i = 0; i < b->balls; i++)
        if ((t = plain_ball(b, i, O, d)) < best) best = t, body = i;
    for (int i = 0; i < b->walls; i++)
        if ((t = plain_wall(b, i, O, d)) < best) best = t, body = WALL_LEFT + i;
    for (int i = 0; i < b->halves; i++)
        if ((t = plain_half(b, i, O, d)) < best) best = t, body = LAMP;
    *nearest = best;
    return body;
}

static inline bool plain_blocked(const plain_box *b, vec O, vec d, double far) {
    for (int i = 0; i < b->balls; i++)
        if (plain_ball(b, i, O, d) < far) return true;
    for (int i = 0; i < b->walls; i++)
        if (plain_wall(b, i, O, d) < far) return true;
    for (int i = 0; i < b->halves; i++)
        if (plain_half(b, i, O, d) < far) return true;
    return false;
}

static inline vec plain_normal(const plain_box *b, int body, vec p) {
    if (body < WALL_LEFT) return vec_scale(1 / b->ball[body].r, vec_sub(p, b->ball[body].c));
    return body < LAMP ? b->wall[body - WALL_LEFT].n : b->lamp_n;
}

// ---- light ---------------------------------------------------------------------------

static inline vec plain_cosine(vec n, rng *g) {
    const double phi = 2 * PI * rng_real(g), r2 = rng_real(g), r = sqrt(r2);
    const vec other = fabs(n.x) > 0.5 ? (vec){0, 1, 0} : (vec){1, 0, 0};
    const vec s = wide_unit(wide_cross(other, n)), t = wide_cross(n, s);
    return vec_add(vec_add(vec_scale(r * cos(phi), s), vec_scale(r * sin(phi), t)),
                   vec_scale(sqrt(1 - r2), n));
}

// The light of the lamp at p, by a point of it, with the weight of the power heuristic.
static inline vec plain_direct(const plain_box *b, vec p, vec n, vec albedo, rng *g) {
    const int i = rng_real(g) < 0.5 ? 0 : 1; // the halves are equal
    double u = rng_real(g), v = rng_real(g);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const vec y =
        vec_add(b->half[i].p, vec_add(vec_scale(u, b->half[i].e), vec_scale(v, b->half[i].f)));
    const vec w = vec_sub(y, p);
    const double square = wide_dot(w, w), distance = sqrt(square);
    const vec d = vec_scale(1 / distance, w);
    const double cosine = wide_dot(n, d), from_lamp = -wide_dot(b->lamp_n, d);
    if (cosine <= 0 || from_lamp <= 0 || plain_blocked(b, p, d, distance - 2 * plain_epsilon))
        return (vec){0, 0, 0};
    const double by_lamp = square / (from_lamp * b->lamp_area), k = cosine / PI / by_lamp;
    return vec_scale(cosine / (PI * by_lamp * (1 + k * k)), vec_mul(albedo, b->emittance));
}

// The share of a lamp that a direction of the density p ran into.
static inline double plain_share(const plain_box *b, vec d, double t, double p) {
    const double k = t * t / (-wide_dot(b->lamp_n, d) * b->lamp_area) / p;
    return 1 / (1 + k * k);
}

// Russian roulette from the fourth bounce on; false: the path ends.
static inline bool plain_goes_on(vec *C, int bounce, rng *g) {
    double q = C->x > C->y ? C->x : C->y;
    if (C->z > q) q = C->z;
    if (q == 0) return false;
    if (bounce < 3) return true;
    if (q > 0.95) q = 0.95;
    if (rng_real(g) >= q) return false;
    *C = vec_scale(1 / q, *C);
    return true;
}

// flatten: as light_trace.
__attribute__((flatten)) static inline vec plain_trace(const plain_box *b, vec O, vec d, int s,
                                                       rng *g) {
    vec C = {1, 1, 1}, L = {0, 0, 0};
    double p = 0;
    for (int bounce = 0;; bounce++) {
        double t;
        const int body = plain_nearest(b, O, d, &t);
        if (body < 0) return L;
        O = vec_add(O, vec_scale(t, d));
        vec n = plain_normal(b, body, O);
        const bool front = wide_dot(n, d) < 0;
        if (body == LAMP && front)
            L = vec_add(L, vec_scale(bounce == 0 ? 1 : plain_share(b, d, t, p),
                                     vec_mul(C, b->emittance)));
        if (!front) n = vec_scale(-1, n);
        if (bounce == s) return L;
        L = vec_add(L, vec_mul(C, plain_direct(b, O, n, b->albedo[body], g)));
        d = plain_cosine(n, g);
        p = wide_dot(n, d) / PI;
        C = vec_mul(C, b->albedo[body]);
        if (!plain_goes_on(&C, bounce, g)) return L;
    }
}

// ---- beside the course's -----------------------------------------------------------------

enum { PLAIN_SIDE = 64, PLAIN_RAYS = PLAIN_SIDE * PLAIN_SIDE };

// A ray for path i: one through each pixel of a small picture, then again.
static inline ray plain_ray(const camera *cam, int i, rng *g) {
    const int x = i % PLAIN_SIDE, y = i / PLAIN_SIDE % PLAIN_SIDE;
    const real dx = rng_real(g);
    const real dy = rng_real(g);
    return camera_ray(cam, (real)x + dx, (real)y + dy);
}

typedef double (*path_light)(const void *data, int i); // the green light of path i

// Both must draw one picture, or their times say nothing. Six standard errors: were the seed
// another each time, one run in five hundred million would complain for nothing.
static inline void plain_check(path_light course, path_light plain, const void *data) {
    running a = {0}, b = {0};
    for (int i = 0; i < 64 * PLAIN_RAYS; i++) {
        running_add(&a, course(data, i));
        running_add(&b, plain(data, i));
    }
    const double se = hypot(running_standard_error(&a), running_standard_error(&b));
    if (!(fabs(a.mean - b.mean) <= 6 * se))
        die(EXIT_RUN, "plain.h: its box has the brightness %.5f, the course's %.5f +- %.5f",
            b.mean, a.mean, se);
}

static inline double plain_seconds(path_light f, const void *data) {
    const double start = clock_seconds();
    double sum = 0;
    for (int i = 0; i < PLAIN_RAYS; i++) sum += f(data, i);
    keep(sum);
    return clock_seconds() - start;
}

// The best of many rounds, in turns.
static inline void plain_measure(const char *name, path_light course, path_light plain,
                                 const void *data) {
    double a = INFINITY, b = INFINITY;
    plain_check(course, plain, data);
    for (int round = 0; round < 25; round++) {
        a = fmin(a, plain_seconds(course, data));
        b = fmin(b, plain_seconds(plain, data));
    }
    const char *table = "speed: beside plain C", *cost = "ns a path";
    csv_row(table, "plain.h", "threads", 1, "", NAN, cost, 1e9 * b / PLAIN_RAYS);
    csv_row(table, name, "threads", 1, "", NAN, cost, 1e9 * a / PLAIN_RAYS);
}

#endif
