// Wrong: a copy of g for each point: all are the same.
// Expect: draw from g itself, not from a copy
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    double mean = 0, squares = 0;
    for (long i = 1; i <= n; i++) {
        rng h = *g;
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = rng_double(&h);
        const double value = f(data, x), before = value - mean;
        mean += before / (double)i;
        squares += before * (value - mean);
    }
    if (n == 1) return (estimate){mean, INFINITY, n};
    return (estimate){mean, sqrt(squares / (double)(n - 1) / (double)n), n};
}
