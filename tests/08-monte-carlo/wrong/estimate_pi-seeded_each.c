// Wrong: seeds a generator for each point: all are the same.
// Expect: all points
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    double inside = 0;
    const uint64_t seed = rng_bits(g);
    for (long i = 0; i < n; i++) {
        rng h = rng_seed(seed, 0);
        inside += montecarlo_slide(1, &h);
    }
    const double p = inside / (double)n;
    const double error = n > 1 ? 4 * sqrt(p * (1 - p) / (double)(n - 1)) : (double)INFINITY;
    return (estimate){4 * p, error, n};
}
