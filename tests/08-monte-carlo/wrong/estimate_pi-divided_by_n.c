// Wrong: n where n - 1 belongs.
// Expect: n where n - 1 belongs
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    const double p = montecarlo_slide(n, g);
    const double error = n > 1 ? 4 * sqrt(p * (1 - p) / (double)n) : (double)INFINITY;
    return (estimate){4 * p, error, n};
}
