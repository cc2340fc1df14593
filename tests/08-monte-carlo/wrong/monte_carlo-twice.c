// Wrong: f is called twice for each point, once for the mean, once for the square.
// Expect: f is called once for each of the n points
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate monte_carlo(integrand f, const void *data, int dimensions, long n, rng *g) {
    double sum = 0, squares = 0;
    for (long i = 0; i < n; i++) {
        double x[8];
        for (int k = 0; k < dimensions; k++) x[k] = rng_double(g);
        sum += f(data, x);
        squares += f(data, x) * f(data, x);
    }
    const double N = (double)n, mean = sum / N;
    if (n == 1) return (estimate){mean, INFINITY, 1};
    return (estimate){mean, sqrt(fmax(squares - N * mean * mean, 0) / (N - 1) / N), n};
}
