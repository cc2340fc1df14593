// Wrong: only the column is kept below 1.
// Expect: g's second draw is 1 - 2^-53
// Expect: never 1: m - 1 + draw is rounded
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    const double u = ((double)(i % m) + a) / (double)m;
    const double v = ((double)(i / m) + b) / (double)m;
    return (point2){fmin(u, 1 - DBL_EPSILON / 2), v};
}
