// Wrong: only the columns are stratified.
// Expect: squares hold no point
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    return (point2){fmin(((double)(i % m) + a) / (double)m, 1 - DBL_EPSILON / 2), b};
}
