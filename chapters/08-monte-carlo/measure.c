// measure.c: the error against the number of points, for random and better points; the
// curse of dimension, answered; how often the standard error keeps its word; sums in
// float, and variances of numbers with a large mean. Nothing here depends on `real`.
#include <stdlib.h>

#include "chapters/08-monte-carlo/monte_carlo.h"
#include "common/die.h"

enum { ROUNDS = 9 };

static const int two = 2, one = 1;

// ---- π by the lecture's way, six decades ------------------------------------------------

// The root of the mean square error of `runs` estimates of n points.
static double pi_error(long n, int runs) {
    double *off = calloc((size_t)runs, sizeof *off), sum = 0;
    if (!off) die(EXIT_RUN, "no memory for %d runs", runs);
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < runs; k++) {
        rng g = rng_sample(8, k, 0, (int)log2((double)n));
        off[k] = estimate_pi(n, &g).value - PI;
    }
    for (int k = 0; k < runs; k++) sum += off[k] * off[k]; // in order: the same sum always
    free(off);
    return sqrt(sum / runs);
}

static void measure_slope(void) {
    for (long n = 10; n <= 10000000; n *= 10) {
        const int runs = n <= 10000 ? 1000 : n == 100000 ? 400 : n == 1000000 ? 64 : 16;
        csv_row("pi: six decades", "measured", "points", (double)n, "error of π",
                pi_error(n, runs), "ns", NAN);
        csv_row("pi: six decades", "sqrt(π(4 - π)/n)", "points", (double)n, "error of π",
                sqrt(PI * (4 - PI) / (double)n), "ns", NAN);
    }
}

// ---- better points ---------------------------------------------------------------------

typedef struct {
    const char *table;
    integrand f;
    const void *data;
} problem;

static const problem problems[] = {{"points: circle", four_in_circle, NULL},
                                   {"points: smooth", product_of_exp, &two}};

enum { POWERS = 8 }; // 4 to 4^8 points

// 1000 sets, then fewer, down to 64. The root of a mean square over k sets is known to
// 1/sqrt(2k): 2 % with 1000 sets, 9 % with 64.
static int sets_of(int power) {
    static const int sets[POWERS + 1] = {0, 1000, 1000, 1000, 1000, 1000, 512, 128, 64};
    return sets[power];
}

static void measure_points(const problem *p) {
    double error[POINT_KINDS][POWERS + 1];
#pragma omp parallel for schedule(dynamic)
    for (int job = POINT_KINDS * POWERS - 1; job >= 0; job--) {
        const int kind = job % POINT_KINDS, power = 1 + job / POINT_KINDS;
        const int sets = sets_of(power);
        const estimate e =
            points_estimate((point_kind)kind, p->f, p->data, 1L << 2 * power, sets, 8);
        error[kind][power] = e.standard_error * sqrt(sets);
    }
    for (int kind = 0; kind < POINT_KINDS; kind++)
        for (int power = 1; power <= POWERS; power++)
            csv_row(p->table, point_names[kind], "points", (double)(1L << 2 * power),
                    "error of one set", error[kind][power], "ns", NAN);
}

enum { DRAWS = 4096 };

#define TIMED_KIND(kind)                                             \
    static void run_##kind(void *data) {                             \
        double sum = 0;                                              \
        for (long i = 0; i < DRAWS; i++) {                           \
            const point2 p = point_of(kind, i, DRAWS, *(int *)data); \
            sum += p.u + p.v;                                        \
        }                                                            \
        keep(sum);                                                   \
    }
TIMED_KIND(RANDOM)
TIMED_KIND(STRATIFIED)
TIMED_KIND(HALTON)
TIMED_KIND(R2)
TIMED_KIND(SOBOL)

static void run_stream(void *data) {
    rng g = rng_seed(*(unsigned *)data, 0);
    double sum = 0;
    for (long i = 0; i < DRAWS; i++) {
        const double u = rng_double(&g), v = rng_double(&g);
        sum += u + v;
    }
    keep(sum);
}

static void measure_costs(void) {
    static const timed variants[] = {{"random, one after the other", run_stream},
                                     {"random", run_RANDOM},
                                     {"stratified", run_STRATIFIED},
                                     {"Halton", run_HALTON},
                                     {"R2", run_R2},
                                     {"Sobol", run_SOBOL}};
    double ns[COUNT(variants)];
    int seed = 8;
    measure_ns(variants, COUNT(variants), &seed, DRAWS, ROUNDS, ns);
    for (int k = 0; k < COUNT(variants); k++)
        csv_row("points: cost", variants[k].name, "points", DRAWS, "not measured", NAN, "ns",
                ns[k]);
}

// ---- the curse of dimension, answered ----------------------------------------------------

enum { EVALUATIONS = 65536 };

// The midpoint rule with m points an axis: of a product it is the product of the rules.
static double grid_error(long m, int dimensions) {
    double sum = 0;
    for (long i = 0; i < m; i++) {
        const double x = ((double)i + 0.5) / (double)m;
        sum += product_of_exp(&one, &x);
    }
    return fabs(pow(sum / (double)m, dimensions) - 1);
}

static void measure_dimensions(void) {
    enum { RUNS = 32 };
    for (int d = 1; d <= 8; d++) {
        long m = lround(pow(EVALUATIONS, 1.0 / d));
        if (pow((double)m, d) > EVALUATIONS) m--;
        double square[RUNS], sum = 0;
#pragma omp parallel for
        for (int k = 0; k < RUNS; k++) {
            rng g = rng_sample(8, k, d, 0);
            const double off = monte_carlo(product_of_exp, &d, d, EVALUATIONS, &g).value - 1;
            square[k] = off * off;
        }
        for (int k = 0; k < RUNS; k++) sum += square[k];
        csv_row("dimensions", "midpoint grid", "dimensions", d, "error of 65536 evaluations",
                grid_error(m, d), "ns", NAN);
        csv_row("dimensions", "Monte Carlo", "dimensions", d, "error of 65536 evaluations",
                sqrt(sum / RUNS), "ns", NAN);
        csv_row("dimensions", "Monte Carlo, closed form", "dimensions", d,
                "error of 65536 evaluations",
                sqrt((pow((exp(1) + 1) / (2 * (exp(1) - 1)), d) - 1) / EVALUATIONS), "ns", NAN);
    }
}

// ---- the standard error's word -------------------------------------------------------------

// The share of 20,000 runs that lie within z of their own standard errors of π.
static void measure_claim(long n) {
    enum { RUNS = 20000 };
    int within[4] = {0};
    for (int k = 0; k < RUNS; k++) {
        rng g = rng_sample(8, k, 1, (int)n);
        const estimate e = estimate_pi(n, &g);
        for (int z = 1; z <= 3; z++) within[z] += fabs(e.value - PI) <= z * e.standard_error;
    }
    static const char *const names[] = {"", "one standard error", "two standard errors",
                                        "three standard errors"};
    for (int z = 1; z <= 3; z++)
        csv_row("claim", names[z], "points", (double)n, "share of runs further off than",
                1 - (double)within[z] / RUNS, "ns", NAN);
}

// ---- sums in float ---------------------------------------------------------------------

static double plain(const float *x, long n) {
    float sum = 0;
    for (long i = 0; i < n; i++) sum += x[i];
    return (double)sum;
}

static float listed(void *x, long i) {
    return ((const float *)x)[i];
}

static double running_mean(const float *x, long n) {
    return (double)float_running_mean(n, listed, (void *)(uintptr_t)x) * (double)n;
}

static double halves(const float *x, long n) {
    if (n == 1) return (double)x[0];
    return (double)((float)halves(x, n / 2) + (float)halves(x + n / 2, n - n / 2));
}

static double neumaier(const float *x, long n) {
    float sum = 0, lost = 0;
    for (long i = 0; i < n; i++) {
        const float next = sum + x[i];
        lost += fabsf(sum) >= fabsf(x[i]) ? (sum - next) + x[i] : (x[i] - next) + sum;
        sum = next;
    }
    return (double)(sum + lost);
}

static double compensated(const float *x, long n) {
    return (double)compensated_sum(x, n);
}

static double in_double(const float *x, long n) {
    double sum = 0;
    for (long i = 0; i < n; i++) sum += (double)x[i];
    return sum;
}

enum { TIMED_TERMS = 4096, MOST_TERMS = 10000000 };

#define TIMED_SUM(f)                  \
    static void run_##f(void *data) { \
        keep(f(data, TIMED_TERMS));   \
    }
TIMED_SUM(plain)
TIMED_SUM(running_mean)
TIMED_SUM(halves)
TIMED_SUM(neumaier)
TIMED_SUM(compensated)
TIMED_SUM(in_double)

static const struct {
    double (*sum)(const float *x, long n);
    timed timing;
} sums[] = {
    {plain, {"float", run_plain}},
    {running_mean, {"float running mean", run_running_mean}},
    {halves, {"float, by halves", run_halves}},
    {neumaier, {"float, Neumaier", run_neumaier}},
    {compensated, {"float, compensated_sum", run_compensated}},
    {in_double, {"double", run_in_double}},
};

static void measure_sums(const char *table, const float *x) {
    exact truth = 0;
    for (long n = 0, next = 1000; n < MOST_TERMS;) {
        for (; n < next; n++) truth += x[n];
        for (int k = 0; k < COUNT(sums); k++)
            csv_row(table, sums[k].timing.name, "terms", (double)n, "relative error of the sum",
                    fabs((double)((sums[k].sum(x, n) - truth) / truth)), "ns", NAN);
        next *= 10;
    }
}

static void measure_float(void) {
    float *x = malloc(MOST_TERMS * sizeof *x);
    if (!x) die(EXIT_RUN, "no memory for %d floats", MOST_TERMS);
    for (long i = 0; i < MOST_TERMS; i++) x[i] = 0.1f;
    measure_sums("sums: 0.1", x);
    rng g = rng_seed(8, 2);
    for (long i = 0; i < MOST_TERMS; i++) {
        const float at = (float)(rng_bits(&g) >> 8) * 0x1p-24f;
        x[i] = 4 * sqrtf(1 - at * at);
    }
    measure_sums("sums: quarter circle", x);
    timed timings[COUNT(sums)];
    double ns[COUNT(sums)];
    for (int k = 0; k < COUNT(sums); k++) timings[k] = sums[k].timing;
    measure_ns(timings, COUNT(sums), x, TIMED_TERMS, ROUNDS, ns);
    for (int k = 0; k < COUNT(sums); k++)
        csv_row("sums: cost", timings[k].name, "terms", TIMED_TERMS, "not measured", NAN, "ns",
                ns[k]);
    free(x);
}

// ---- the variance of numbers with a large mean -------------------------------------------

enum { VALUES = 1000 };

static double sum_of_squares(const double *x) {
    double sum = 0, squares = 0;
    for (int i = 0; i < VALUES; i++) sum += x[i], squares += x[i] * x[i];
    return (squares - sum * sum / VALUES) / (VALUES - 1);
}

static double welford(const double *x) {
    running s = {0};
    for (int i = 0; i < VALUES; i++) running_add(&s, x[i]);
    return running_variance(&s);
}

static double from_first(const double *x) {
    double shifted[VALUES];
    for (int i = 0; i < VALUES; i++) shifted[i] = x[i] - x[0];
    return sum_of_squares(shifted);
}

static double two_passes(const double *x) {
    double mean = 0, squares = 0;
    for (int i = 0; i < VALUES; i++) mean += x[i] / VALUES;
    for (int i = 0; i < VALUES; i++) squares += (x[i] - mean) * (x[i] - mean);
    return squares / (VALUES - 1);
}

static exact variance_exact(const double *x) {
    exact mean = 0, squares = 0;
    for (int i = 0; i < VALUES; i++) mean += (exact)x[i] / VALUES;
    for (int i = 0; i < VALUES; i++) squares += ((exact)x[i] - mean) * ((exact)x[i] - mean);
    return squares / (VALUES - 1);
}

static void measure_variance(void) {
    static const struct {
        const char *name;
        double (*of)(const double *x);
    } variants[] = {{"sum of squares", sum_of_squares},
                    {"Welford (running_add)", welford},
                    {"differences from the first", from_first},
                    {"two passes", two_passes}};
    for (double mean = 1; mean <= 1e12; mean *= 1e3) {
        rng g = rng_seed(8, 3);
        double x[VALUES];
        for (int i = 0; i < VALUES; i++) // uniform, variance 1
            x[i] = mean + sqrt(12) * (rng_double(&g) - 0.5);
        const exact truth = variance_exact(x);
        for (int k = 0; k < COUNT(variants); k++)
            csv_row("variance", variants[k].name, "mean", mean,
                    "relative error of the variance",
                    fabs((double)((variants[k].of(x) - truth) / truth)), "ns", NAN);
    }
}

int main(void) {
    if (sizeof(real) > sizeof(float)) return 0; // the same numbers again
    measure_slope();
    for (int i = 0; i < COUNT(problems); i++) measure_points(&problems[i]);
    measure_costs();
    measure_dimensions();
    for (long n = 10; n <= 1000; n *= 10) measure_claim(n);
    measure_float();
    measure_variance();
}
