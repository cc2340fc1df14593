// Wrong: the standard error from the true π.
// Expect: from the true π, which an estimate does not know
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    const double p = montecarlo_slide(n, g);
    const double error = n > 1 ? sqrt(PI * (4 - PI) / (double)(n - 1)) : (double)INFINITY;
    return (estimate){4 * p, error, n};
}
