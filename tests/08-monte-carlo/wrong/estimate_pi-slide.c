// Wrong: the lecture's share, π/4.
// Expect: π/4, the share itself, as on the slide
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    const double p = montecarlo_slide(n, g);
    const double error = n > 1 ? sqrt(p * (1 - p) / (double)(n - 1)) : (double)INFINITY;
    return (estimate){p, error, n};
}
