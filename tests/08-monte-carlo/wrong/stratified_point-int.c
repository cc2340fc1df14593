// Wrong: i and m as int, which ends at 2^31.
// Expect: not negative: do i and m stay long?
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    return (point2){fmin(((double)((int)i % (int)m) + a) / (double)m, 1 - DBL_EPSILON / 2),
                    fmin(((double)((int)i / (int)m) + b) / (double)m, 1 - DBL_EPSILON / 2)};
}
