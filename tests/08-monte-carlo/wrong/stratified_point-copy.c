// Wrong: draws from a copy of g.
// Expect: Is g used, itself and not a copy of it?
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    rng h = *g;
    const double a = rng_double(&h), b = rng_double(&h);
    const double u = ((double)(i % m) + a) / (double)m;
    const double v = ((double)(i / m) + b) / (double)m;
    return (point2){fmin(u, 1 - DBL_EPSILON / 2), fmin(v, 1 - DBL_EPSILON / 2)};
}
