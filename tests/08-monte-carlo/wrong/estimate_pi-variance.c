// Wrong: the variance: no square root.
// Expect: the variance: the square root is missing
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    const double p = montecarlo_slide(n, g);
    const double error = n > 1 ? 16 * p * (1 - p) / (double)(n - 1) : (double)INFINITY;
    return (estimate){4 * p, error, n};
}
