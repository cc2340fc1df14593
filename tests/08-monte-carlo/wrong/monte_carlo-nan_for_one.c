// Wrong: no case for n = 1: 0/0.
// Expect: n - 1 is 0 here
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    double mean = 0, squares = 0;
    for (long i = 1; i <= n; i++) {
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = rng_double(g);
        const double value = f(data, x), before = value - mean;
        mean += before / (double)i;
        squares += before * (value - mean);
    }
    return (estimate){mean, sqrt(squares / (double)(n - 1) / (double)n), n};
}
