// Right: column by column, from the top down.
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    const double low = 1 - DBL_EPSILON / 2;
    return (point2){fmin(((double)(i / m) + b) / (double)m, low),
                    fmin(((double)(m - 1 - i % m) + a) / (double)m, low)};
}
