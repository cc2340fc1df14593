// Right: all values are kept: first the mean, then the deviations.
#include "chapters/08-monte-carlo/monte_carlo.h"

#include <stdlib.h>

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    double *value = malloc((size_t)n * sizeof *value);
    double sum = 0, squares = 0;
    for (long i = 0; i < n; i++) {
        double x[8];
        for (int k = dimensions - 1; k >= 0; k--) x[k] = rng_double(g);
        value[i] = f(data, x);
        sum += value[i];
    }
    const double mean = sum / (double)n;
    for (long i = 0; i < n; i++) squares += (value[i] - mean) * (value[i] - mean);
    free(value);
    if (n == 1) return (estimate){mean, INFINITY, 1};
    return (estimate){mean, sqrt(squares / (double)(n - 1) / (double)n), n};
}
