// measure.h: clock, running statistics, higher precision, CSV rows: the trade
// between error and cost, measured.
#ifndef COMMON_MEASURE_H
#define COMMON_MEASURE_H

#include <stdio.h>

#include "common/vec3.h"

// Seconds from some fixed moment, monotonic.
double clock_seconds(void);

// Running mean and variance without cancellation (Welford 1962).
typedef struct {
    long n;
    double mean, m2, min, max;
} running;

void running_add(running *s, double x);
double running_variance(const running *s);       // of one value, n - 1; 0 for n < 2
double running_standard_error(const running *s); // of the mean

// Sorts `x` and returns the quantile q in [0, 1] (nearest rank). NaN counts as
// +infinity. count >= 1.
double quantile(double *x, long count, double q);

// The reference for errors: 113 bits where the compiler has __float128, else
// long double.
#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 exact;
#else
typedef long double exact;
#endif
exact exact_sqrt(exact x); // correct to the last bits; 0 for x <= 0

// Units in the last place: |got - want| / (REAL_EPSILON |want|); 0 when equal.
double relative_error(double got, exact want);

// A formula to be timed: `run` calls it once for each of `calls` cases in `data`.
typedef struct {
    const char *name;
    void (*run)(void *data);
} timed;

// Nanoseconds per call of each variant: the variants take turns, at least
// `rounds` rounds, and the median of each is kept. With the environment
// variable ERRORS_ONLY set nothing is timed and all are 0.
void measure_ns(const timed *variants, int count, void *data, long calls, int rounds,
                double *ns);

// Keeps a result alive, so that the compiler cannot drop the work that made it.
void keep(double x);

// One row of the chapter's table. The header is printed with the first row.
//   table    what is compared: "sphere, distance / radius"
//   variant  which formula
//   x_name   what was varied, x its value
//   error_name, error   the error and against what; NAN: not measured
//   cost_name, cost     "ns", "bytes"; NAN: not measured
void csv_row(const char *table, const char *variant, const char *x_name, double x,
             const char *error_name, double error, const char *cost_name, double cost);

#endif
