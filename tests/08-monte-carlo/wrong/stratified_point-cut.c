// Wrong: cut off at 0.999999.
// Expect: Is what is near 1 cut off too early?
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    const double u = ((double)(i % m) + a) / (double)m;
    const double v = ((double)(i / m) + b) / (double)m;
    return (point2){fmin(u, 0.999999), fmin(v, 0.999999)};
}
