// Right: a quarter of the circle in the square [0, 1)²; Welford's variance.
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    running s = {0};
    for (long i = 0; i < n; i++) {
        const double x = rng_double(g);
        const double y = rng_double(g);
        running_add(&s, x * x + y * y < 1 ? 4 : 0);
    }
    return (estimate){s.mean, n == 1 ? (double)INFINITY : running_standard_error(&s), n};
}
