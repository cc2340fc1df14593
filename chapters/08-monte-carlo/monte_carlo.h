// monte_carlo.h: integrals by random points, how far off they are, and better points.
#ifndef CHAPTER_MONTE_CARLO_H
#define CHAPTER_MONTE_CARLO_H

#include "chapters/07-rendering-equation/rendering.h"
#include "common/measure.h"
#include "common/rng.h"

// An integral's estimate, and how far it lies from the truth: for large n in 68 of 100 runs
// less than one standard error, in 95 less than two.
typedef struct {
    double value, standard_error;
    long n; // evaluations
} estimate;

// The lecture's montecarlo(), line by line, with n points in place of a million. It
// returns the share of the points in the circle: π/4, not π.
double montecarlo_slide(long n, rng *g);

// ---- two integrands to try -----------------------------------------------------------

// 4 in the circle that fills the unit square, 0 outside. In 2 dimensions: integral π,
// variance π(4 - π).
double four_in_circle(const void *nothing, const double *x);

// The product of e^x / (e - 1) over all coordinates; `dimensions` points to an int, their
// number d. Integral 1, variance ((e + 1)/(2(e - 1)))^d - 1.
double product_of_exp(const void *dimensions, const double *x);

// ---- points in the unit square ---------------------------------------------------

typedef enum { RANDOM, STRATIFIED, HALTON, R2, SOBOL, POINT_KINDS } point_kind;
extern const char *const point_names[POINT_KINDS];

// The i-th of n points, 0 <= i < n, each coordinate in [0, 1). Two seeds give
// independent sets (HALTON and R2 are shifted by a random vector, modulo 1;
// SOBOL is Owen-scrambled), and so the mean over seeds is unbiased. STRATIFIED
// needs n = m²; SOBOL is at its best for n = 2^k. In the sequences, HALTON, R2 and
// SOBOL, the points do not depend on n, nor in RANDOM: more can follow.
// Sources: Halton 1960; Roberts 2018; Sobol 1967; Owen 1995; Cranley and Patterson 1976.
typedef struct {
    double u, v;
} point2;
point2 point_of(point_kind kind, long i, long n, uint64_t seed);

// Sobol's i-th point before it is scrambled.
point2 sobol_point(uint64_t i);

// ∫ f over the unit square by `sets` >= 2 independent sets of n points: the mean of the
// sets' means. Its standard error is from the spread of these means, since points of
// one set depend on each other; that of a single set is sqrt(sets) times as large.
estimate points_estimate(point_kind kind, integrand f, const void *data, long n, int sets,
                         uint64_t seed);

// ---- sums in float ---------------------------------------------------------------

// The mean of n terms as a beginner would: float sum, float counter. The counter stops at
// 2^24; the sum loses each term that is below half its last digit.
float float_mean(long n, float (*term)(void *data, long i), void *data);

// The running mean in float, mean += (x - mean) / i: it stalls as soon as the step is
// below half the mean's last digit.
float float_running_mean(long n, float (*term)(void *data, long i), void *data);

// Exercises: exercises/08-monte-carlo/ ------------------------------------------

// π from n random points of the square [-1, 1)²: 4 times the share in the unit disc.
// The standard error is that of the value: 4 sqrt(p(1-p)/(n-1)), p the share found;
// INFINITY for n = 1: one point says nothing of its error.
estimate estimate_pi(long n, rng *g);

// ∫ f over the unit cube in `dimensions` (1 to 8) by n uniform points: the mean of f,
// and the standard error sqrt(variance / n), the variance with n - 1, without
// cancellation for any mean (Welford 1962). n >= 1; for n = 1 the standard error is
// INFINITY. Draws exactly n · dimensions numbers, by rng_double, from g itself: point after
// point. On a region of volume V an integral is V times the mean.
estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g);

// The i-th of n = m² stratified points: one uniform point in each of the m x m squares,
// every square exactly once over i = 0 .. n - 1; each coordinate in [0, 1), never 1: what would
// round to 1 stays in the last column or row. The random numbers are rng_double's of g.
// 1 <= m <= 2^31.
point2 stratified_point(long i, long m, rng *g);

// The radical inverse: the digits of i in `base` (2 to 1000) mirrored at the point.
// i = 6, base 2: 110 becomes 0.011 = 3/8. In [0, 1), never 1, also for i near 2^62. Exact to
// rounding: relative error at most 64 u, u = 2^-53 (one for each digit, at the worst).
double radical_inverse(int base, uint64_t i);

// The sum of n >= 0 floats by float arithmetic alone: a second float keeps what the sum
// loses. Error at most 2u |sum| + 4n u² (sum of |x|), u = 2^-24, where the plain sum has
// n u (sum of |x|). All terms and their sums so far are finite.
// Sources: Kahan 1965; Neumaier 1974, for both signs; Dekker 1971, for any n.
float compensated_sum(const float *x, long n);

#endif
