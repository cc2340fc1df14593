// Wrong: draws from a copy of g.
// Expect: draw from g itself, not from a copy
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    rng h = *g;
    const double p = montecarlo_slide(n, &h);
    const double error = n > 1 ? 4 * sqrt(p * (1 - p) / (double)(n - 1)) : (double)INFINITY;
    return (estimate){4 * p, error, n};
}
