// Right: sums of the differences from the first value, which is near the mean.
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    double first = 0, sum = 0, squares = 0;
    for (long i = 0; i < n; i++) {
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = rng_double(g);
        const double value = f(data, x);
        if (i == 0) first = value;
        sum += value - first;
        squares += (value - first) * (value - first);
    }
    const double N = (double)n, mean = sum / N;
    if (n == 1) return (estimate){first, INFINITY, 1};
    const double variance = fmax(squares - N * mean * mean, 0) / (N - 1);
    return (estimate){first + mean, sqrt(variance / N), n};
}
