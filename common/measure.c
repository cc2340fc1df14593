// measure.c: the error against a reference, the cost by the clock, one CSV row for both.
#define _POSIX_C_SOURCE 200809L
#include "common/measure.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "common/die.h"

double clock_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void running_add(running *s, double x) {
    s->n++;
    if (s->n == 1 || x < s->min) s->min = x;
    if (s->n == 1 || x > s->max) s->max = x;
    const double before = x - s->mean;
    s->mean += before / (double)s->n;
    s->m2 += before * (x - s->mean);
}

double running_variance(const running *s) {
    return s->n < 2 ? 0 : s->m2 / (double)(s->n - 1);
}

double running_standard_error(const running *s) {
    return s->n < 2 ? 0 : sqrt(running_variance(s) / (double)s->n);
}

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double quantile(double *x, long count, double q) {
    for (long i = 0; i < count; i++)
        if (isnan(x[i])) x[i] = INFINITY;
    qsort(x, (size_t)count, sizeof *x, ascending);
    const long rank = (long)ceil(q * (double)count); // 1 is the smallest
    return x[rank < 1 ? 0 : rank > count ? count - 1 : rank - 1];
}

// Newton doubles the correct bits: 53 or 64 become more than 113 in two steps.
exact exact_sqrt(exact x) {
    if (x <= 0) return 0;
    exact y = sqrtl((long double)x);
    if (!isfinite((long double)y)) return y;
    for (int step = 0; step < 2; step++) y = (y + x / y) / 2;
    return y;
}

double relative_error(double got, exact want) {
    if (got == want) return 0;
    const exact difference = got < want ? want - got : got - want;
    const exact size = want < 0 ? -want : want;
    const double error = (double)(difference / (REAL_EPSILON * size));
    return isnan(error) ? (double)INFINITY : error; // no number is as wrong as can be
}

static const double round_seconds = 5e-3; // long beside the clock's step, short beside a pause

static double seconds_of(const timed *variant, void *data, long repetitions) {
    const double start = clock_seconds();
    for (long i = 0; i < repetitions; i++) variant->run(data);
    return clock_seconds() - start;
}

// Doubles until the clock sees enough; warms caches and branch prediction by the way.
static long repetitions_for(const timed *variant, void *data) {
    long repetitions = 1;
    while (seconds_of(variant, data, repetitions) < round_seconds / 2) repetitions *= 2;
    return repetitions;
}

void measure_ns(const timed *variants, int count, void *data, long calls, int rounds,
                double *ns) {
    for (int v = 0; v < count; v++) ns[v] = 0;
    if (getenv("ERRORS_ONLY")) return;
    double *seconds = calloc((size_t)count * (size_t)rounds, sizeof *seconds);
    long *repetitions = calloc((size_t)count, sizeof *repetitions);
    if (!seconds || !repetitions) die(EXIT_RUN, "no memory for %d rounds", rounds);
    for (int v = 0; v < count; v++) repetitions[v] = repetitions_for(&variants[v], data);
    for (int r = 0; r < rounds; r++) // in turns: a slow moment of the machine hits all alike
        for (int v = 0; v < count; v++)
            seconds[v * rounds + r] = seconds_of(&variants[v], data, repetitions[v]);
    for (int v = 0; v < count; v++)
        ns[v] = 1e9 * quantile(&seconds[v * rounds], rounds, 0.5) /
                ((double)repetitions[v] * (double)calls);
    free(repetitions);
    free(seconds);
}

static volatile double kept;

void keep(double x) {
    kept = x;
}

static void print_text(const char *text) {
    if (!strpbrk(text, ",\"\n")) {
        fputs(text, stdout);
        return;
    }
    putchar('"');
    for (; *text; text++) {
        if (*text == '"') putchar('"');
        putchar(*text);
    }
    putchar('"');
}

static void print_number(int digits, double x) {
    if (!isnan(x)) printf("%.*g", digits, x);
}

void csv_row(const char *table, const char *variant, const char *x_name, double x,
             const char *error_name, double error, const char *cost_name, double cost) {
    static bool has_header;
    if (!has_header) puts("table,variant,real,x_name,x,error_name,error,cost_name,cost");
    has_header = true;
    print_text(table), putchar(',');
    print_text(variant), fputs("," REAL_NAME ",", stdout);
    print_text(x_name), putchar(',');
    print_number(9, x), putchar(',');
    print_text(error_name), putchar(',');
    print_number(3, error), putchar(',');
    print_text(cost_name), putchar(',');
    print_number(4, cost), putchar('\n');
}
