// chance.c: random points and directions.
#include "common/real.h"

#include "common/rng.h"
#include "slides/figures/figures.h"

// Darts at a square, and how many of them are in the circle.
void darts_figure(const char *folder) {
    enum { DARTS = 600 };
    drawing d = svg_begin(folder, "darts", (point){-1.05, -1.3}, (point){1.05, 1.05}, 460);
    rng g = rng_seed(1, 8);
    int inside = 0;
    svg_box(&d, (point){-1, -1}, (point){1, 1}, OBJECT, NO_FILL);
    for (int i = 0; i < DARTS; i++) {
        const double x = 2 * rng_double(&g) - 1, y = 2 * rng_double(&g) - 1;
        const bool in = x * x + y * y <= 1;
        inside += in;
        svg_circle(&d, (point){x, y}, 0.006, in ? LIGHT : OBJECT, NO_FILL);
    }
    svg_circle(&d, (point){0, 0}, 1, RAY, NO_FILL);
    char words[32];
    snprintf(words, sizeof words, "%d / %d", inside, DARTS);
    svg_words(&d, (point){0, -1.17}, 0, 0, words);
    svg_end(&d);
}

// ---- a density that follows the light -----------------------------------------------------

static double light(double x) { // much of it in one place
    return 0.25 + 2.4 * exp(-30 * (x - 0.68) * (x - 0.68));
}

static const double all_light = 1.0215; // its integral from 0 to 1

static double place(double u) { // where the part u of all light has come in
    double low = 0, sum = 0;
    enum { STEPS = 2000 };
    while (low < 1 && sum < u * all_light) sum += light(low) / STEPS, low += 1.0 / STEPS;
    return low;
}

static const double height = 1.0 / 3;

// Left uniform places, right places with a density proportional to f: the bars are the samples,
// as high as f / p.
void importance_figure(const char *folder) {
    drawing d =
        svg_begin(folder, "importance", (point){-0.05, -0.24}, (point){2.45, 0.94}, 780);
    enum { CURVE = 100, SAMPLES = 14 };
    for (int side = 0; side < 2; side++) {
        const double left = 1.35 * side;
        svg_line(&d, (point){left, 0}, (point){left + 1.05, 0}, OBJECT);
        for (int i = 0; i < SAMPLES; i++) {
            const double u = (i + 0.5) / SAMPLES, x = side ? place(u) : u;
            const double ratio = side ? all_light : light(x);
            svg_line(&d, (point){left + x, 0}, (point){left + x, height * ratio}, RAY);
            svg_dot(&d, (point){left + x, height * ratio}, RAY);
        }
        for (int i = 0; i < CURVE; i++) {
            const double x = (double)i / CURVE, y = (i + 1.0) / CURVE;
            svg_line(&d, (point){left + x, height * light(x)},
                     (point){left + y, height * light(y)}, LIGHT);
        }
        svg_symbol(&d, (point){left + 0.5, 0}, 0, -1.1, side ? "p ∝ f" : "p = 1");
        svg_symbol(&d, (point){left + 0.83, 0.7}, 0.3, 0.3, "f");
    }
    svg_end(&d);
}

// Equal steps on the disc, lifted to the hemisphere: dense at the top, where the cosine is large.
void lift_figure(const char *folder) {
    drawing d = svg_begin(folder, "lift", (point){-1.2, -0.25}, (point){1.2, 1.35}, 640);
    const point x = {0, 0};
    enum { POINTS = 13 };
    svg_line(&d, (point){-1.2, 0}, (point){1.2, 0}, OBJECT);
    svg_arc(&d, x, 1, 0, PI, HELP);
    for (int i = 0; i < POINTS; i++) {
        const double u = (2 * i + 1.0) / POINTS - 1;
        const point on = {u, sqrt(1 - u * u)};
        svg_line(&d, (point){u, 0}, on, FAINT);
        svg_line(&d, x, on, THIN);
        svg_dot(&d, (point){u, 0}, LIGHT);
        svg_dot(&d, on, RAY);
    }
    svg_arrow(&d, x, (point){0, 1.3}, OBJECT);
    svg_symbol(&d, (point){0, 1.3}, 0.7, 0, "n");
    svg_dot(&d, x, OBJECT);
    svg_symbol(&d, x, 0, -0.9, "x");
    svg_end(&d);
}
