// monte_carlo.h: integrals by random points, how far off they are, and better points.
#ifndef CHAPTER_MONTE_CARLO_H
#define CHAPTER_MONTE_CARLO_H

#include "chapters/07-rendering-equation/rendering.h"
#include "common/measure.h"
#include "common/rng.h"

// An integral's estimate, and how far it lies from the truth: in 68 of 100 runs less
// than one standard error, in 95 less than two.
typedef struct {
    double value, standard_error;
    long n; // evaluations
} estimate;

// The lecture's montecarlo(), line by line, with n points in place of a million. It
// returns the share of the points in the circle: π/4, not π.
double montecarlo_slide(long n, rng *g);

// ---- points in the unit square ---------------------------------------------------

typedef enum { RANDOM, STRATIFIED, HALTON, R2, SOBOL, POINT_KINDS } point_kind;
extern const char *const point_names[POINT_KINDS];

// The i-th of n points, 0 <= i < n, each coordinate in [0, 1). Two seeds give
// independent sets (HALTON and R2 are shifted by a random vector, modulo 1;
// SOBOL is Owen-scrambled), and so the mean over seeds is unbiased. STRATIFIED
// needs n = m²; SOBOL is at its best for n = 2^k.
typedef struct {
    double u, v;
} point2;
point2 point_of(point_kind kind, long i, long n, uint64_t seed);

// ---- sums in float ---------------------------------------------------------------

// The mean of n terms as a beginner would: float sum, float counter. The counter stops at
// 2^24; the sum loses each term that is below half its last digit.
float float_mean(long n, float (*term)(void *data, long i), void *data);

// The running mean in float, mean += (x - mean) / i: it stalls as soon as the step is
// below half the mean's last digit.
float float_running_mean(long n, float (*term)(void *data, long i), void *data);

// Exercises: exercises/08-monte-carlo/ ------------------------------------------

// π from n random points of the square [-1, 1)²: 4 times the share in the unit disc.
// The standard error is that of the value: 4 sqrt(p(1-p)/(n-1)), p the share found.
estimate estimate_pi(long n, rng *g);

// ∫ f over the unit cube in `dimensions` (1 to 8) by n uniform points: the mean of f,
// and the standard error sqrt(variance / n), the variance with n - 1, without
// cancellation for any mean (Welford 1962). n >= 1; for n = 1 the standard error is
// INFINITY: one value says nothing of its error.
estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g);

// The i-th of n = m² stratified points: one uniform point in each of the m x m squares,
// every square exactly once over i = 0 .. n - 1. u and v are rng_double's of g.
point2 stratified_point(long i, long m, rng *g);

// The radical inverse: the digits of i in `base` (2 to 1000) mirrored at the point.
// i = 6, base 2: 110 becomes 0.011 = 3/8. In [0, 1), also for i near 2^62. Exact to rounding.
double radical_inverse(int base, uint64_t i);

// The sum of n >= 0 floats by float arithmetic alone: a second float keeps what the sum
// loses. Error at most 2u |sum| + n² u² (sum of |x|), u = 2^-24, where the plain sum has
// n u (sum of |x|). Source: Kahan 1965; Neumaier 1974.
float compensated_sum(const float *x, long n);

#endif
