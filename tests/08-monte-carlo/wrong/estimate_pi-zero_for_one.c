// Wrong: the standard error 0 for one point.
// Expect: no special case for n = 1
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    const double p = montecarlo_slide(n, g);
    return (estimate){4 * p, n > 1 ? 4 * sqrt(p * (1 - p) / (double)(n - 1)) : 0, n};
}
