// Wrong: points of [-1, 1).
// Expect: in [0, 1)
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    running s = {0};
    for (long i = 0; i < n; i++) {
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = 2 * rng_double(g) - 1;
        running_add(&s, f(data, x));
    }
    return (estimate){s.mean, n == 1 ? (double)INFINITY : running_standard_error(&s), n};
}
