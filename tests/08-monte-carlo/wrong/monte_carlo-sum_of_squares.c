// Wrong: the sum of squares minus the square of the sum.
// Expect: Keep the sum of squared deviations from the mean so far
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    double sum = 0, squares = 0;
    for (long i = 0; i < n; i++) {
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = rng_double(g);
        const double value = f(data, x);
        sum += value;
        squares += value * value;
    }
    const double N = (double)n, mean = sum / N;
    if (n == 1) return (estimate){mean, INFINITY, 1};
    return (estimate){mean, sqrt(fmax(squares - N * mean * mean, 0) / (N - 1) / N), n};
}
