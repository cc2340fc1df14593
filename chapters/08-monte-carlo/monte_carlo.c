// monte_carlo.c: the lecture's estimate, integrands with known answers, and sums in
// float. The estimators are exercises. See monte_carlo.h.
#include "chapters/08-monte-carlo/monte_carlo.h"

double montecarlo_slide(long n, rng *g) {
    long inside = 0;
    for (long i = 0; i < n; i++) {
        const double x = 2 * rng_double(g) - 1;
        const double y = 2 * rng_double(g) - 1;
        if (x * x + y * y <= 1) inside += 1;
    }
    return (double)inside / (double)n;
}

// ---- two integrands to try -----------------------------------------------------------

double four_in_circle(const void *nothing, const double *x) {
    (void)nothing;
    const double a = 2 * x[0] - 1, b = 2 * x[1] - 1;
    return a * a + b * b <= 1 ? 4 : 0;
}

double product_of_exp(const void *dimensions, const double *x) {
    const int d = *(const int *)dimensions;
    double product = 1;
    for (int k = 0; k < d; k++) product *= exp(x[k]) / (exp(1.0) - 1);
    return product;
}

// ---- sums in float ---------------------------------------------------------------

float float_mean(long n, float (*term)(void *data, long i), void *data) {
    float sum = 0, count = 0;
    for (long i = 0; i < n; i++) {
        sum += term(data, i);
        count += 1;
    }
    return sum / count;
}

float float_running_mean(long n, float (*term)(void *data, long i), void *data) {
    float mean = 0;
    for (long i = 1; i <= n; i++) mean += (term(data, i - 1) - mean) / (float)i;
    return mean;
}
