// Wrong: mean and variance in float.
// Expect: a large mean
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    float mean = 0, squares = 0;
    for (long i = 1; i <= n; i++) {
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = rng_double(g);
        const float value = (float)f(data, x), before = value - mean;
        mean += before / (float)i;
        squares += before * (value - mean);
    }
    if (n == 1) return (estimate){(double)mean, INFINITY, 1};
    return (estimate){(double)mean, sqrt((double)squares / (double)(n - 1) / (double)n), n};
}
