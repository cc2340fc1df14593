// quadratics.h: ways to solve a quadratic equation, their error and their cost; measure.c
// prints it.
#ifndef CHAPTER_SPHERE_QUADRATICS_H
#define CHAPTER_SPHERE_QUADRATICS_H

#include "chapters/04-sphere/sphere.h"
#include "common/measure.h"

// ---- in real arithmetic ------------------------------------------------------

static roots quadratic_slide(real a, real b, real c) {
    const real discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return (roots){0, 0, 0};
    const real s = sqrt(discriminant);
    const real t0 = (-b - s) / (2 * a), t1 = (-b + s) / (2 * a);
    return (roots){2, fmin(t0, t1), fmax(t0, t1)};
}

static roots roots_by_q(real a, real half_b, real c, real quarter) {
    if (!(quarter >= 0)) return (roots){0, 0, 0};
    const real q = -(half_b + copysign(sqrt(quarter), half_b));
    const real t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return (roots){2, fmin(t0, t1), fmax(t0, t1)};
}

static roots quadratic_q(real a, real b, real c) {
    return roots_by_q(a, b / 2, c, b / 2 * (b / 2) - a * c);
}

// The discriminant as Kahan's difference of products.
static roots quadratic_kahan(real a, real b, real c) {
    const real half_b = b / 2, ac = a * c;
    const real error = fma(-a, c, ac);
    return roots_by_q(a, half_b, c, fma(half_b, half_b, -ac) + error);
}

// ---- mixed -------------------------------------------------------------------

static roots quadratic_mixed(real a, real b, real c) {
    return solve_quadratic(a, b, c);
}

static roots quadratic_stable(real a, real b, real c) {
    return stable_quadratic(a, b, c);
}

// ---- the variants -----------------------------------------------------------------------

enum { QUADRATICS = 1 << 12, QUADRATIC_ROUNDS = 25 };

typedef struct {
    real a[QUADRATICS], b[QUADRATICS], c[QUADRATICS];
} quadratics;

#define RUN_QUADRATIC(f)                                                             \
    static void run_##f(void *data) {                                                \
        const quadratics *k = data;                                                  \
        double sum = 0;                                                              \
        for (int i = 0; i < QUADRATICS; i++) sum += f(k->a[i], k->b[i], k->c[i]).t0; \
        keep(sum);                                                                   \
    }
RUN_QUADRATIC(quadratic_slide)
RUN_QUADRATIC(quadratic_q)
RUN_QUADRATIC(quadratic_kahan)
RUN_QUADRATIC(quadratic_mixed)
RUN_QUADRATIC(quadratic_stable)

typedef struct {
    const char *name;
    roots (*solve)(real a, real b, real c);
    void (*run)(void *data);
} solver;

static const solver solvers[] = {
    {"slide", quadratic_slide, run_quadratic_slide},
    {"q", quadratic_q, run_quadratic_q},
    {"q, Kahan", quadratic_kahan, run_quadratic_kahan},
    {"mixed, slide", quadratic_mixed, run_quadratic_mixed},
    {"stable_quadratic (mixed, q, Kahan)", quadratic_stable, run_quadratic_stable},
};

// In a build with double the last two are the first and the third again.
static int solver_count(void) {
    return sizeof(real) == sizeof(float) ? COUNT(solvers) : COUNT(solvers) - 2;
}

// ---- the cases ---------------------------------------------------------------------------

static double signed_size(rng *g) { // 0.5 to 2, either sign
    const double x = 0.5 + 1.5 * rng_double(g);
    return rng_bits(g) & 1 ? x : -x;
}

// b² / 4ac = ratio (1 ± near), all three coefficients of about the given size.
static void fill_quadratics(quadratics *k, double ratio, double near, double size) {
    rng g = rng_seed(4, 3);
    for (int i = 0; i < QUADRATICS; i++) {
        const real a = (real)signed_size(&g), b = (real)signed_size(&g);
        const double off = rng_bits(&g) & 1 ? near : -near;
        k->a[i] = (real)(a * size);
        k->b[i] = (real)(b * size);
        k->c[i] = (real)((double)b * b / (4 * (double)a * ratio * (1 + off)) * size);
    }
}

static exact discriminant_of(const quadratics *k, int i) {
    return (exact)k->b[i] * k->b[i] - 4 * (exact)k->a[i] * k->c[i];
}

// The root near zero, the one that cancels: c / q.
static exact smaller_root(const quadratics *k, int i) {
    const exact b = k->b[i], s = exact_sqrt(discriminant_of(k, i));
    return 2 * (exact)k->c[i] / (b > 0 ? -b - s : -b + s);
}

// ---- the tables ----------------------------------------------------------------------------

static double median_error(const quadratics *k, const solver *by) {
    static double error[QUADRATICS];
    for (int i = 0; i < QUADRATICS; i++) {
        const roots q = by->solve(k->a[i], k->b[i], k->c[i]);
        const double t = fabs(q.t0) < fabs(q.t1) ? q.t0 : q.t1;
        error[i] = relative_error((real)t, smaller_root(k, i)) * REAL_EPSILON;
    }
    return quantile(error, QUADRATICS, 0.5);
}

static double wrong_counts(const quadratics *k, const solver *by) {
    int wrong = 0;
    for (int i = 0; i < QUADRATICS; i++)
        wrong +=
            (by->solve(k->a[i], k->b[i], k->c[i]).count > 0) != (discriminant_of(k, i) >= 0);
    return (double)wrong / QUADRATICS;
}

static void tabulate_counts(const quadratics *k, const char *table, const char *x_name,
                            double x) {
    for (int s = 0; s < solver_count(); s++)
        csv_row(table, solvers[s].name, x_name, x, "share of wrong counts",
                wrong_counts(k, &solvers[s]), "ns", NAN);
}

static void tabulate_errors(quadratics *k, const char *table, const char *x_name, double x,
                            bool also_time) {
    timed timings[COUNT(solvers)];
    double ns[COUNT(solvers)];
    for (int s = 0; s < solver_count(); s++)
        timings[s] = (timed){solvers[s].name, solvers[s].run};
    if (also_time) measure_ns(timings, solver_count(), k, QUADRATICS, QUADRATIC_ROUNDS, ns);
    for (int s = 0; s < solver_count(); s++)
        csv_row(table, solvers[s].name, x_name, x, "relative error of the smaller root, median",
                median_error(k, &solvers[s]), "ns", also_time ? ns[s] : NAN);
}

static void measure_quadratics(void) {
    static quadratics k;
    for (int e = 1; e <= 13; e += 2) {
        fill_quadratics(&k, pow(10, e), 0, 1);
        tabulate_errors(&k, "quadratic: smaller root", "b² / 4ac", pow(10, e), false);
    }
    fill_quadratics(&k, 10, 0, 1);
    tabulate_errors(&k, "quadratic: cost", "b² / 4ac", 10, true);
    for (int e = -16; e <= -4; e += 2) {
        fill_quadratics(&k, 1, pow(10, e), 1);
        tabulate_counts(&k, "quadratic: nearly double root", "|1 - 4ac / b²|", pow(10, e));
    }
    for (int e = -30; e <= 30; e += 10) {
        fill_quadratics(&k, 1, 0.5, pow(10, e));
        tabulate_counts(&k, "quadratic: size", "coefficients times", pow(10, e));
    }
}

#endif
