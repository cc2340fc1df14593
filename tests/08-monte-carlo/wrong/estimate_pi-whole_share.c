// Wrong: the share in whole numbers: 0.
// Expect: is the share divided in whole numbers, in / n?
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    long in = 0;
    for (long i = 0; i < n; i++) {
        const double x = 2 * rng_double(g) - 1, y = 2 * rng_double(g) - 1;
        in += x * x + y * y <= 1;
    }
    const double p = (double)(in / n);
    return (estimate){4 * p, n > 1 ? 4 * sqrt(p * (1 - p) / (double)(n - 1)) : (double)INFINITY,
                      n};
}
