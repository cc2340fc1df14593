// Wrong: Welford's step with the deviation from the old mean, twice.
// Expect: the deviation from the mean before it, squared
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    double mean = 0, squares = 0;
    for (long i = 1; i <= n; i++) {
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = rng_double(g);
        const double before = f(data, x) - mean;
        mean += before / (double)i;
        squares += before * before;
    }
    if (n == 1) return (estimate){mean, INFINITY, 1};
    return (estimate){mean, sqrt(squares / (double)(n - 1) / (double)n), n};
}
