// speed.h: how fast the box is drawn, and where the time goes. measure.c prints it.
//
// Where the time goes cannot be read off a clock that is asked at every step: the asking
// would take longer than the step. So the paths are walked once by walk(), light_trace with
// a notebook, and every ray and every stop is written down. Then each kind of work is done
// alone, for all that was written, and timed as a whole; what is left of light_trace's time
// is shading. Alone, work may be a little faster than among other work.
#ifndef CHAPTER_SPEED_H
#define CHAPTER_SPEED_H

#include <stdlib.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "chapters/10-importance-sampling/plain.h"

enum {
    WALK_SIDE = 64,
    WALKS = WALK_SIDE * WALK_SIDE,
    MOST_STEPS = 17 * WALKS,
    WALK_DEPTH = 16
};

typedef struct {
    ray shadow;
    stop at;
    rng before_aim, before_scatter;
    int except;
    bool aimed; // shadow was traced
} step;

typedef struct {
    lit_room room;
    ray from[WALKS];
    rng g[WALKS];
    ray searched[MOST_STEPS];
    step steps[MOST_STEPS];
    int searches, stops;
} notebook;

// The ray that direct_light sends, by the same random numbers.
static void note_shadow(notebook *b, step *s) {
    rng g = s->before_aim;
    const aim a = lamps_aim(&b->room.lamps, s->at.start, &g);
    if (a.body < 0 || !a.on.front) return;
    const color f = surface_brdf(s->at.m, s->at.n, s->at.o, a.v);
    s->aimed = f.x > 0 || f.y > 0 || f.z > 0;
    s->shadow = (ray){s->at.start, sub(a.end, s->at.start)};
    s->except = a.except;
}

static color walk(notebook *b, ray r, rng *g) {
    color C = {1, 1, 1}, L = {0, 0, 0};
    real p = 0;
    r.d = normalize(r.d);
    for (int bounce = 0;; bounce++) {
        int body = 0;
        b->searched[b->searches++] = r;
        const hit h = scene_nearest(&b->room.bodies, r, 0, NO_HIT, &body);
        if (h.t == NO_HIT) return L;
        step *s = &b->steps[b->stops];
        *s = (step){.at = stop_at(&b->room.surfaces[body], r, h), .before_aim = *g};
        const real share = bounce == 0 ? 1 : share_of_hit(&b->room, body, r, h, p);
        if (h.front) L = add(L, scale(share, mul(C, s->at.m->emittance)));
        if (bounce == WALK_DEPTH) return L;
        b->stops++;
        note_shadow(b, s);
        L = add(L, mul(C, direct_light(&b->room, &s->at, g)));
        s->before_scatter = *g;
        const scattered next = surface_scatter(s->at.m, s->at.n, s->at.o, g);
        if (!(next.p > 0)) return L;
        C = mul(C, next.weight);
        if (C.x == 0 && C.y == 0 && C.z == 0) return L;
        const real weight = roulette(survival(C, bounce), g);
        if (weight == 0) return L;
        C = scale(weight, C);
        p = next.p;
        r = (ray){s->at.start, next.v};
    }
}

static bool same_light(color a, color b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static lit_room without_equations(lit_room sc) {
    sc.bodies.equations = NULL;
    return sc;
}

static void write_down(notebook *b) {
    const camera cam = box_camera(WALK_SIDE, WALK_SIDE);
    const lit_room plain = without_equations(b->room);
    for (int i = 0; i < WALKS; i++) {
        b->g[i] = rng_sample(1, i % WALK_SIDE, i / WALK_SIDE, 0);
        b->from[i] = camera_ray(&cam, (real)(i % WALK_SIDE), (real)(i / WALK_SIDE));
        rng g = b->g[i], again = b->g[i], once_more = b->g[i];
        const color L = light_trace(&b->room, b->from[i], WALK_DEPTH, &g);
        if (!same_light(L, walk(b, b->from[i], &again)))
            die(EXIT_RUN, "speed.h: walk() no longer does what light_trace does");
        if (sizeof(real) == sizeof(float) &&
            !same_light(L, light_trace(&plain, b->from[i], WALK_DEPTH, &once_more)))
            die(EXIT_RUN, "speed.h: the equations of the planes change the light");
    }
}

// ---- each kind of work by itself -----------------------------------------------------

static void walk_all(const notebook *b, const lit_room *sc) {
    double sum = 0;
    for (int i = 0; i < WALKS; i++) {
        rng g = b->g[i];
        sum += (double)light_trace(sc, b->from[i], WALK_DEPTH, &g).y;
    }
    keep(sum);
}

static void do_all(void *data) {
    const notebook *b = data;
    walk_all(b, &b->room);
}

static void do_all_plainly(void *data) {
    const notebook *b = data;
    const lit_room plain = without_equations(b->room);
    walk_all(b, &plain);
}

#define FLAT __attribute__((flatten)) // compiled into one function, as in light_trace

FLAT static void do_nearest(void *data) {
    const notebook *b = data;
    double sum = 0;
    int body = 0;
    for (int i = 0; i < b->searches; i++)
        sum += (double)scene_nearest(&b->room.bodies, b->searched[i], 0, NO_HIT, &body).t;
    keep(sum + body);
}

FLAT static void do_shadows(void *data) {
    const notebook *b = data;
    int sum = 0;
    for (int i = 0; i < b->stops; i++)
        if (b->steps[i].aimed)
            sum += scene_blocked(&b->room.bodies, b->steps[i].shadow, 1 - 4 * REAL_EPSILON,
                                 b->steps[i].except);
    keep(sum);
}

FLAT static void do_sampling(void *data) {
    const notebook *b = data;
    double sum = 0;
    for (int i = 0; i < b->stops; i++) {
        const step *s = &b->steps[i];
        rng g = s->before_aim, h = s->before_scatter;
        const aim a = lamps_aim(&b->room.lamps, s->at.start, &g);
        if (a.body >= 0)
            sum += (double)lamps_probability(&b->room.lamps, a.body, s->at.start, a.on);
        sum += (double)surface_scatter(s->at.m, s->at.n, s->at.o, &h).p;
    }
    keep(sum);
}

static const struct {
    const char *name;
    void (*run)(void *data);
} works[] = {
    {"all", do_all},
    {"all, with the planes met one by one", do_all_plainly},
    {"intersection: nearest hits", do_nearest},
    {"intersection: shadow rays", do_shadows},
    {"sampling: lamps and directions", do_sampling},
};
enum { PARTS = 2 }; // from here on they are parts of the first

// The best of many rounds, in turns: a share of times is worth nothing when one of them was
// disturbed.
static void measure_shares(notebook *b) {
    double best[COUNT(works)];
    for (int i = 0; i < COUNT(works); i++) best[i] = INFINITY;
    for (int round = 0; round < 25; round++)
        for (int i = 0; i < COUNT(works); i++) {
            const double start = clock_seconds();
            works[i].run(b);
            best[i] = fmin(best[i], clock_seconds() - start);
        }
    double rest = best[0];
    const char *table = "speed: where the time goes", *cost = "ns a path";
    for (int i = 0; i < COUNT(works); i++) {
        if (i >= PARTS) rest -= best[i];
        csv_row(table, works[i].name, "threads", 1, "", NAN, cost, 1e9 * best[i] / WALKS);
    }
    csv_row(table, "shading and the rest", "threads", 1, "", NAN, cost, 1e9 * rest / WALKS);
}

// ---- the whole -----------------------------------------------------------------------

static color look_into(const void *sc, ray r, rng *g) {
    return light_trace(sc, r, WALK_DEPTH, g);
}

static int all_cores(void) {
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

static void use_cores(int threads) {
#ifdef _OPENMP
    omp_set_num_threads(threads);
#else
    (void)threads;
#endif
}

// Best of five: what the machine can do when nothing disturbs it.
static double samples_a_second(const lit_room *sc, int threads) {
    const options opt = {.samples = 16, .seed = 1};
    const camera cam = box_camera(128, 128);
    double best = INFINITY;
    use_cores(threads);
    for (int round = 0; round < 5; round++) {
        const double start = clock_seconds();
        image img = render("box", &cam, look_into, sc, &opt);
        best = fmin(best, clock_seconds() - start);
        image_free(&img);
    }
    return 128 * 128 * 16 / best;
}

static void measure_rates(lit_room *sc) {
    static const char *const names[] = {"uniform", "BRDF", "lamps", "both, balance",
                                        "both, power"};
    const int cores = all_cores();
    for (int threads = 1; threads <= cores; threads += cores > 1 ? cores - 1 : 1)
        for (int how = BY_UNIFORM; how <= BY_POWER; how++) {
            sc->strategy = (strategy)how;
            csv_row("speed: the box", names[how], "threads", threads, "", NAN, "Msamples/s",
                    1e-6 * samples_a_second(sc, threads));
        }
}

// ---- beside plain C ------------------------------------------------------------------

typedef struct {
    lit_room room;
    plain_box plain;
    camera cam;
} matte_box;

static double by_course(const void *data, int i) {
    const matte_box *b = data;
    rng g = rng_seed(1, (uint64_t)i);
    return (double)light_trace(&b->room, plain_ray(&b->cam, i, &g), WALK_DEPTH, &g).y;
}

static double by_plain(const void *data, int i) {
    const matte_box *b = data;
    rng g = rng_seed(2, (uint64_t)i);
    const ray r = plain_ray(&b->cam, i, &g);
    return plain_trace(&b->plain, widen(r.O), wide_unit(widen(r.d)), WALK_DEPTH, &g).y;
}

static void measure_beside_plain(void) {
    surface surfaces[BOX_BODIES];
    fill_box_surfaces(surfaces, 0);
    matte_box b = {lit(box_bodies, surfaces, BY_POWER), plain_build(&box_bodies, surfaces),
                   box_camera(PLAIN_SIDE, PLAIN_SIDE)};
    plain_measure("light_trace", by_course, by_plain, &b);
    lit_free(&b.room);
}

static void measure_speed(void) {
    surface surfaces[BOX_BODIES];
    notebook *b = calloc(1, sizeof *b);
    if (!b) die(EXIT_RUN, "no memory for the paths");
    fill_box_surfaces(surfaces, (real)0.2);
    b->room = lit(box_bodies, surfaces, BY_POWER);
    write_down(b);
    measure_shares(b);
    measure_rates(&b->room);
    measure_beside_plain();
    lit_free(&b->room);
    free(b);
}

#endif
