// 08-monte-carlo: π from points of the square, by chance and by design; how far the
// estimates are off; and how float sums go wrong.
#include <stdio.h>

#include "chapters/08-monte-carlo/chart.h"
#include "chapters/08-monte-carlo/monte_carlo.h"

#define PAINT(r, g, b) \
    { (real)(r), (real)(g), (real)(b) }

// Colours that most eyes tell apart. Source: Okabe and Ito 2008.
static const color paints[POINT_KINDS] = {PAINT(0.02, 0.02, 0.02), PAINT(0.79, 0.35, 0),
                                          PAINT(0, 0.34, 0.17), PAINT(0, 0.17, 0.45),
                                          PAINT(0.67, 0.11, 0)};
static const char *const titles[POINT_KINDS] = {"RANDOM", "STRATIFIED", "HALTON", "R2",
                                                "SOBOL"};

// ---- the numbers ---------------------------------------------------------------------

enum { SETS = 32 };

// The largest number of points, up to n, that this kind can be had with.
static long fitting(point_kind kind, long n) {
    const long m = (long)sqrt((double)n);
    return kind == STRATIFIED ? m * m : n;
}

static void print_estimate(const char *what, estimate e) {
    printf("%-34s %.6f, standard error %.6f, off by %9.6f\n", what, e.value, e.standard_error,
           e.value - PI);
}

static void print_estimates(const options *opt) {
    rng g = rng_seed(opt->seed, 0), same = g;
    printf("the lecture's montecarlo()         %.6f: that is π/4\n",
           montecarlo_slide(1000000, &same));
    print_estimate("estimate_pi, 1000000 points", estimate_pi(1000000, &g));
    print_estimate("monte_carlo, 1000000 points",
                   monte_carlo(four_in_circle, NULL, 2, 1000000, &g));
    printf("π from %d independent sets of %d points each:\n", SETS, opt->samples);
    for (int k = 0; k < POINT_KINDS; k++)
        print_estimate(point_names[k],
                       points_estimate(k, four_in_circle, NULL, fitting(k, opt->samples), SETS,
                                       opt->seed));
}

// ---- the points ----------------------------------------------------------------------

static void draw_circle(const frame *f) {
    enum { SIDES = 180 };
    for (int i = 0; i < SIDES; i++) {
        const double a = 2 * PI * i / SIDES, b = 2 * PI * (i + 1) / SIDES;
        chart_line(f, 0.5 + 0.5 * cos(a), 0.5 + 0.5 * sin(a), 0.5 + 0.5 * cos(b),
                   0.5 + 0.5 * sin(b), 1, chart_pale);
    }
}

static void draw_border(const frame *f) {
    const double x[] = {f->x0, f->x1, f->x1, f->x0, f->x0};
    const double y[] = {f->y0, f->y0, f->y1, f->y1, f->y0};
    for (int i = 0; i < 4; i++) chart_line(f, x[i], y[i], x[i + 1], y[i + 1], 2, chart_pale);
}

static void draw_point(const frame *f, point2 p, double radius) {
    static const color in = PAINT(0.67, 0.11, 0), out = PAINT(0, 0.17, 0.45);
    const bool inside = four_in_circle(NULL, (const double[]){p.u, p.v}) > 0;
    chart_dot(f, p.u, p.v, radius, inside ? in : out);
}

// The midpoint rule's points of chapter 07, for comparison.
static point2 grid_point(long i, long m) {
    return (point2){((double)(i % m) + 0.5) / (double)m, ((double)(i / m) + 0.5) / (double)m};
}

// One set in its square. The kind POINT_KINDS is the grid.
static void draw_panel(const frame *f, int kind, const options *opt) {
    const bool grid = kind == POINT_KINDS;
    const long n = fitting(grid ? STRATIFIED : (point_kind)kind, opt->samples);
    const double radius = fmax(0.7, 0.2 * (f->right - f->left) / sqrt((double)n));
    draw_border(f);
    draw_circle(f);
    for (long i = 0; i < n; i++)
        draw_point(f,
                   grid ? grid_point(i, lround(sqrt((double)n)))
                        : point_of((point_kind)kind, i, n, opt->seed),
                   radius);
    chart_text(f->on, f->left, f->bottom + 6, grid ? "GRID" : titles[kind], chart_ink);
}

static image show_points(const options *opt) {
    static const int kinds[] = {RANDOM, STRATIFIED, POINT_KINDS, HALTON, R2, SOBOL};
    enum { COLUMNS = 3, BESIDE = 16, BELOW = 28 }; // pixels between panels
    image img = chart_paper_new(opt->width, opt->height);
    const int cell_x = opt->width / COLUMNS, cell_y = opt->height / 2;
    const double side = fmax(1, fmin(cell_x - BESIDE, cell_y - BELOW));
    for (int k = 0; k < COUNT(kinds); k++) {
        const double left = k % COLUMNS * cell_x + floor((cell_x - side) / 2);
        const double top = k / COLUMNS * cell_y + 6;
        const frame f = {&img, left, left + side, top, top + side, 0, 1, 0, 1};
        draw_panel(&f, kinds[k], opt);
    }
    return img;
}

// ---- the error against the number of points --------------------------------------------

enum { POWERS = 8 }; // 4, 16, ... 4^8 points: squares, and powers of two

// The root of the mean square error of one set of 4^power points, from 1000 sets, then fewer.
static double error_of(point_kind kind, int power, integrand f, const void *data,
                       uint64_t seed) {
    static const int counts[POWERS + 1] = {0, 1000, 1000, 1000, 1000, 1000, 512, 128, 64};
    const int sets = counts[power];
    return points_estimate(kind, f, data, 1L << 2 * power, sets, seed).standard_error *
           sqrt(sets);
}

// The names at the curves' ends, from the top down and never one on another.
static void draw_names(const frame *f, const double last[POINT_KINDS]) {
    const double apart = 13 * (f->y1 - f->y0) / (f->bottom - f->top);
    double free_below = INFINITY;
    bool done[POINT_KINDS] = {false};
    for (int round = 0; round < POINT_KINDS; round++) {
        int top = -1;
        for (int k = 0; k < POINT_KINDS; k++)
            if (!done[k] && (top < 0 || last[k] > last[top])) top = k;
        free_below = fmin(log10(last[top]), free_below - apart);
        chart_name(f, free_below, titles[top], paints[top]);
        done[top] = true;
    }
}

static void draw_curve(const frame *f, const double error[POWERS + 1], color c) {
    for (int p = 1; p <= POWERS; p++) {
        const double x = p * log10(4), y = log10(error[p]);
        chart_dot(f, x, y, 3, c);
        if (p > 1) chart_line(f, x - log10(4), log10(error[p - 1]), x, y, 2, c);
    }
}

static image show_error(const options *opt, integrand f, const void *data, double low) {
    double error[POINT_KINDS][POWERS + 1], last[POINT_KINDS];
#pragma omp parallel for schedule(dynamic)
    for (int job = POINT_KINDS * POWERS - 1; job >= 0; job--) { // the long ones first
        const int kind = job % POINT_KINDS, power = 1 + job / POINT_KINDS;
        error[kind][power] = error_of((point_kind)kind, power, f, data, opt->seed);
    }
    image img = chart_paper_new(opt->width, opt->height);
    const frame chart = {&img, 50, opt->width - 96.0, 12, opt->height - 26.0, 0.4, 5.0,
                         low,  0.3};
    chart_powers_x(&chart);
    chart_powers_y(&chart);
    for (int k = 0; k < POINT_KINDS; k++) {
        draw_curve(&chart, error[k], paints[k]);
        last[k] = error[k][POWERS];
        printf("%-12s slope from 16 to 65536 points: %.2f\n", point_names[k],
               log(error[k][POWERS] / error[k][2]) / log(4096));
    }
    draw_names(&chart, last);
    return img;
}

// ---- estimates on their way ------------------------------------------------------------

enum { FIRST = 10, LAST = 100000 }; // points

// One and two standard errors around π.
static void draw_bands(const frame *f) {
    static const color band[] = {PAINT(0.8, 0.8, 0.78), PAINT(0.62, 0.62, 0.6)};
    for (int z = 2; z >= 1; z--)
        for (double x = f->x0; x < f->x1; x += 0.5 * (f->x1 - f->x0) / (f->right - f->left)) {
            const double e = z * sqrt(PI * (4 - PI) / pow(10, x));
            chart_line(f, x, PI - e, x, PI + e, 1, band[2 - z]);
        }
    chart_line(f, f->x0, PI, f->x1, PI, 1, chart_paper);
}

// The lecture's loop, stopped now and then to look at the share.
static void draw_run(const frame *f, rng g, color c) {
    double inside = 0, x0 = 0, y0 = 0;
    for (long n = 1, next = FIRST; n <= LAST; n++) {
        inside += montecarlo_slide(1, &g);
        if (n != next) continue;
        const double x = log10((double)n), y = 4 * inside / (double)n;
        if (n > FIRST) chart_line(f, x0, y0, x, y, 1, c);
        x0 = x, y0 = y;
        next = n + 1 + n / 50;
    }
}

static image show_running(const options *opt) {
    enum { RUNS = 12 };
    image img = chart_paper_new(opt->width, opt->height);
    const frame f = {&img, 46, opt->width - 24.0, 12,      opt->height - 26.0,
                     1,    5,  PI - 0.5,          PI + 0.5};
    chart_powers_x(&f);
    draw_bands(&f);
    for (uint64_t run = RUNS; run > 0; run--) // the first one above all others
        draw_run(&f, rng_seed(opt->seed, run), paints[run == 1 ? SOBOL : R2]);
    chart_mark(&f, PI, "3.14", chart_ink);
    return img;
}

// ---- sums in float -------------------------------------------------------------------

// The height of the quarter circle at a random place: π on average.
static float height(void *g, long i) {
    (void)i;
    const float x = (float)(rng_bits(g) >> 8) * 0x1p-24f;
    return 4 * sqrtf(1 - x * x);
}

static image show_float(const options *opt) {
    enum { STEPS = 16 };
    image img = chart_paper_new(opt->width, opt->height);
    const frame f = {&img, 46, opt->width - 112.0, 12, opt->height - 26.0, 6, 7.6, 2.8, 4.1};
    const double step = (f.x1 - f.x0) / STEPS;
    double sum[STEPS + 1], mean[STEPS + 1];
#pragma omp parallel for schedule(dynamic)
    for (int k = STEPS; k >= 0; k--) { // the long ones first
        rng g = rng_seed(opt->seed, 0), same = g;
        const long n = lround(pow(10, f.x0 + step * k));
        sum[k] = (double)float_mean(n, height, &g);
        mean[k] = (double)float_running_mean(n, height, &same);
    }
    chart_powers_x(&f);
    chart_line(&f, f.x0, PI, f.x1, PI, 1, chart_ink);
    for (int k = 0; k < STEPS; k++) {
        const double x = f.x0 + step * k;
        chart_line(&f, x, sum[k], x + step, sum[k + 1], 2, paints[SOBOL]);
        chart_line(&f, x, mean[k], x + step, mean[k + 1], 2, paints[R2]);
    }
    chart_mark(&f, PI, "3.14", chart_ink);
    chart_mark(&f, 4, "4.00", chart_ink);
    chart_name(&f, 4, "SUM / COUNT", paints[SOBOL]);
    chart_name(&f, mean[STEPS], "RUNNING MEAN", paints[R2]);
    printf("%ld numbers: sum / count %.6f, running mean %.6f\n", lround(pow(10, f.x1)),
           sum[STEPS], mean[STEPS]);
    return img;
}

// ---- the program -----------------------------------------------------------------------

static const choice pictures[] = {
    {"points", "the point sets and the circle; --samples points in each"},
    {"circle", "the error of π against the number of points, both logarithmic"},
    {"smooth", "the same for a smooth integrand, e^x e^y"},
    {"running", "twelve estimates on their way from 10 to 100,000 points"},
    {"float", "the mean of up to 40 million numbers in float: a sum, and a running mean"},
    {0},
};

static image show(const options *opt) {
    static const int two = 2;
    if (shows(opt, "circle")) return show_error(opt, four_in_circle, NULL, -4.2);
    if (shows(opt, "smooth")) return show_error(opt, product_of_exp, &two, -8.2);
    if (shows(opt, "running")) return show_running(opt);
    if (shows(opt, "float")) return show_float(opt);
    print_estimates(opt);
    return show_points(opt);
}

int main(int argc, char **argv) {
    const program about = {
        .name = "08-monte-carlo",
        .summary = "Finds π with --samples points of a square, from random to evenly spread.",
        .uses = USES_SIZE | USES_SAMPLES | USES_SEED | USES_THREADS,
        .defaults = {.width = 720,
                     .height = 520,
                     .samples = 256,
                     .seed = 1,
                     .out = "08-monte-carlo.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    image img = show(&opt);
    image_write(&img, opt.out);
    image_free(&img);
}
