// Wrong: each x is the y of the point before: points come in chains.
// Expect: is a number of one point used again for the next?
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    long inside = 0;
    double x = 2 * rng_double(g) - 1;
    for (long i = 0; i < n; i++) {
        const double y = 2 * rng_double(g) - 1;
        if (x * x + y * y <= 1) inside++;
        x = y;
    }
    const double p = (double)inside / (double)n;
    const double error = n > 1 ? 4 * sqrt(p * (1 - p) / (double)(n - 1)) : (double)INFINITY;
    return (estimate){4 * p, error, n};
}
