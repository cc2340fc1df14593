// Wrong: value and standard_error swapped.
// Expect: value and standard_error are swapped
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    const double p = montecarlo_slide(n, g);
    const double error = n > 1 ? 4 * sqrt(p * (1 - p) / (double)(n - 1)) : (double)INFINITY;
    return (estimate){error, 4 * p, n};
}
