// Wrong: x and y are the same number.
// Expect: x = y: are two numbers drawn for each point?
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    long inside = 0;
    for (long i = 0; i < n; i++) {
        const double x = 2 * rng_double(g) - 1, y = x;
        if (x * x + y * y <= 1) inside++;
    }
    const double p = (double)inside / (double)n;
    const double error = n > 1 ? 4 * sqrt(p * (1 - p) / (double)(n - 1)) : (double)INFINITY;
    return (estimate){4 * p, error, n};
}
