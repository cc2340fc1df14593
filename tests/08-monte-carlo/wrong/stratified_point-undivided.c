// Wrong: the division by m is missing.
// Expect: in [0, 1)
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    return (point2){(double)(i % m) + a, (double)(i / m) + b};
}
