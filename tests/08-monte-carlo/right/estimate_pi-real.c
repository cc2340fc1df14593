// Right: random numbers of 24 bits, in real.
#include "chapters/08-monte-carlo/monte_carlo.h"

estimate estimate_pi(long n, rng *g) {
    long inside = 0;
    for (long i = 0; i < n; i++) {
        const real x = 2 * rng_real(g) - 1;
        const real y = 2 * rng_real(g) - 1;
        if (x * x + y * y <= 1) inside++;
    }
    if (n == 1) return (estimate){4.0 * (double)inside, INFINITY, 1};
    const double value = 4 * (double)inside / (double)n;
    return (estimate){value, sqrt(value * (4 - value) / (double)(n - 1)), n};
}
