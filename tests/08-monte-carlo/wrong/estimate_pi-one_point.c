// Wrong: 0/0 for one point.
// Expect: n - 1 is 0 here
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    const double p = montecarlo_slide(n, g);
    return (estimate){4 * p, 4 * sqrt(p * (1 - p) / (double)(n - 1)), n};
}
