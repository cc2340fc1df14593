// Right: with the running statistics of common/measure.h.
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    running s = {0};
    for (long i = 0; i < n; i++) {
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = rng_double(g);
        running_add(&s, f(data, x));
    }
    if (n == 1) return (estimate){s.mean, INFINITY, 1};
    const double variance = running_variance(&s);
    return (estimate){s.mean, sqrt(variance / (double)n), n};
}
