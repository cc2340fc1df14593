// measure.c: the noise of each strategy against samples and against time; what each sampler
// costs; the energy that rough metal loses; how fast the box is drawn, where the time goes, and
// what a page of plain C takes.
#include <stdlib.h>

#include "chapters/10-importance-sampling/samplers.h"
#include "chapters/10-importance-sampling/speed.h"

// ---- the noise of the strategies -----------------------------------------------------

enum { SIDE = 24, PIXELS = SIDE * SIDE, DEPTH = 16, REFERENCE = 1024 };
static const int counts[] = {1, 4, 16, 64, 256};
enum { MOST = 256 };

static const struct {
    const char *name;
    strategy how;
} ways[] = {
    {"uniform", BY_UNIFORM},       {"BRDF", BY_BRDF},         {"lamps", BY_LAMPS},
    {"both, balance", BY_BALANCE}, {"both, power", BY_POWER},
};

static lit_room small_box(surface surfaces[BOX_BODIES], strategy how) {
    fill_box_surfaces(surfaces, (real)0.2);
    return lit(box_bodies, surfaces, how);
}

static color sample(const lit_room *sc, const camera *cam, int pixel, int i, uint64_t seed) {
    const int x = pixel % SIDE, y = pixel / SIDE;
    rng g = rng_sample(seed, x, y, i);
    const real dx = rng_real(&g);
    const real dy = rng_real(&g);
    return light_trace(sc, camera_ray(cam, (real)x + dx, (real)y + dy), DEPTH, &g);
}

typedef struct {
    running red, green, blue;
} running_color;

static void add_color(running_color *s, color c) {
    running_add(&s->red, (double)c.x);
    running_add(&s->green, (double)c.y);
    running_add(&s->blue, (double)c.z);
}

// The reference, and the square of its own error, which would count as the strategy's.
typedef struct {
    double light[PIXELS][3], noise[PIXELS];
} reference;

static double variance_of_mean(const running_color *s) {
    const double se[] = {running_standard_error(&s->red), running_standard_error(&s->green),
                         running_standard_error(&s->blue)};
    return se[0] * se[0] + se[1] * se[1] + se[2] * se[2];
}

static void find_reference(reference *truth, const camera *cam) {
    surface surfaces[BOX_BODIES];
    lit_room sc = small_box(surfaces, BY_POWER);
#pragma omp parallel for schedule(dynamic)
    for (int p = 0; p < PIXELS; p++) {
        running_color sum = {0};
        for (int i = 0; i < REFERENCE; i++) add_color(&sum, sample(&sc, cam, p, i, 2));
        truth->light[p][0] = sum.red.mean;
        truth->light[p][1] = sum.green.mean;
        truth->light[p][2] = sum.blue.mean;
        truth->noise[p] = variance_of_mean(&sum);
    }
    lit_free(&sc);
}

// The squared error of each pixel after counts[0], counts[1], ... samples.
static void squared_errors(const reference *truth, const camera *cam, strategy how,
                           double squares[COUNT(counts)][PIXELS]) {
    surface surfaces[BOX_BODIES];
    lit_room sc = small_box(surfaces, how);
#pragma omp parallel for schedule(dynamic)
    for (int p = 0; p < PIXELS; p++) {
        running_color sum = {0};
        for (int i = 0, k = 0; i < MOST; i++) {
            add_color(&sum, sample(&sc, cam, p, i, 1));
            if (i + 1 != counts[k]) continue;
            const double off[] = {sum.red.mean - truth->light[p][0],
                                  sum.green.mean - truth->light[p][1],
                                  sum.blue.mean - truth->light[p][2]};
            squares[k++][p] =
                off[0] * off[0] + off[1] * off[1] + off[2] * off[2] - truth->noise[p];
        }
    }
    lit_free(&sc);
}

static double root_mean(const double *squares) {
    double sum = 0;
    for (int p = 0; p < PIXELS; p++) sum += squares[p];
    return sqrt(sum / (3 * PIXELS));
}

// ---- the time of the strategies ------------------------------------------------------

typedef struct {
    lit_room room;
    camera cam;
} timed_box;

enum { TIMED_SAMPLES = 8 };

static void run_box(void *data) {
    const timed_box *b = data;
    double sum = 0;
    for (int p = 0; p < PIXELS; p++)
        for (int i = 0; i < TIMED_SAMPLES; i++)
            sum += (double)sample(&b->room, &b->cam, p, i, 1).y;
    keep(sum);
}

// Nanoseconds a sample on one thread, all strategies in turns.
static void time_strategies(const camera *cam, double ns[COUNT(ways)]) {
    surface surfaces[BOX_BODIES];
    static timed_box box;
    for (int w = 0; w < COUNT(ways); w++) ns[w] = INFINITY;
    for (int round = 0; round < 5; round++)
        for (int w = 0; w < COUNT(ways); w++) {
            box = (timed_box){small_box(surfaces, ways[w].how), *cam};
            const timed run = {ways[w].name, run_box};
            double once;
            measure_ns(&run, 1, &box, PIXELS * TIMED_SAMPLES, 1, &once);
            ns[w] = fmin(ns[w], once);
            lit_free(&box.room);
        }
}

// Beside the errors, in a full run, the times: errors and times together give the
// efficiency 1 / (variance x time).
static void measure_strategies(void) {
    static reference truth;
    static double squares[COUNT(counts)][PIXELS];
    const camera cam = box_camera(SIDE, SIDE);
    const bool clocked = !getenv("ERRORS_ONLY");
    double ns[COUNT(ways)] = {0};
    if (clocked) time_strategies(&cam, ns);
    find_reference(&truth, &cam);
    for (int w = 0; w < COUNT(ways); w++) {
        squared_errors(&truth, &cam, ways[w].how, squares);
        for (int k = 0; k < COUNT(counts); k++) {
            const double error = root_mean(squares[k]), n = counts[k];
            csv_row("strategies: noise", ways[w].name, "samples", n, "RMSE", error, "seconds",
                    1e-9 * ns[w] * n * PIXELS);
            if (clocked)
                csv_row("strategies: efficiency", ways[w].name, "samples", n, "", NAN,
                        "1/(variance x time)", 1e9 / (error * error * ns[w] * n));
        }
    }
}

int main(void) {
    measure_strategies();
    measure_samplers();
    measure_energy();
    if (!getenv("ERRORS_ONLY")) measure_speed();
}
