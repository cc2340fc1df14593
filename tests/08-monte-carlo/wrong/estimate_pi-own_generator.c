// Wrong: a generator of its own, the same in every run.
// Expect: is g the caller's, and used?
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    (void)g;
    rng own = rng_seed(42, 54);
    const double p = montecarlo_slide(n, &own);
    const double error = n > 1 ? 4 * sqrt(p * (1 - p) / (double)(n - 1)) : (double)INFINITY;
    return (estimate){4 * p, error, n};
}
