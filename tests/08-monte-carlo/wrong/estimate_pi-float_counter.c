// Wrong: counts in float, which ends at 2^24.
// Expect: a float counter: it stops at 2^24
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    float inside = 0;
    for (long i = 0; i < n; i++) {
        const double x = 2 * rng_double(g) - 1;
        const double y = 2 * rng_double(g) - 1;
        if (x * x + y * y <= 1) inside += 1;
    }
    const double p = (double)inside / (double)n;
    const double error = n > 1 ? 4 * sqrt(p * (1 - p) / (double)(n - 1)) : (double)INFINITY;
    return (estimate){4 * p, error, n};
}
