// Wrong: one random number for all coordinates.
// Expect: they are not the same number: is each drawn?
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    running s = {0};
    for (long i = 0; i < n; i++) {
        const double u = rng_double(g);
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = u;
        running_add(&s, f(data, x));
    }
    return (estimate){s.mean, n == 1 ? (double)INFINITY : running_standard_error(&s), n};
}
