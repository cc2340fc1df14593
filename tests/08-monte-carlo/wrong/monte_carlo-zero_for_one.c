// Wrong: the standard error 0 for one value.
// Expect: no special case for n = 1: one value does not tell its spread: INFINITY
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    running s = {0};
    for (long i = 0; i < n; i++) {
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = rng_double(g);
        running_add(&s, f(data, x));
    }
    return (estimate){s.mean, running_standard_error(&s), n};
}
