// Wrong: the standard error of the share, not of 4 times the share.
// Expect: that of π/4: the factor 4 is missing
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    const double p = montecarlo_slide(n, g);
    const double error = n > 1 ? sqrt(p * (1 - p) / (double)(n - 1)) : (double)INFINITY;
    return (estimate){4 * p, error, n};
}
