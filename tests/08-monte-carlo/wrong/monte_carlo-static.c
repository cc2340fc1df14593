// Wrong: the running mean is static: the next run goes on with it.
// Expect: nothing is left from the run before
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    static running s;
    for (long i = 0; i < n; i++) {
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = rng_double(g);
        running_add(&s, f(data, x));
    }
    return (estimate){s.mean, n == 1 ? (double)INFINITY : running_standard_error(&s), n};
}
