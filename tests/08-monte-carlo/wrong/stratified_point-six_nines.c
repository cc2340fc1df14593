// Wrong: what rounds to 1 becomes 0.999999, in another square when m is large.
// Expect: still in the last column and row, as with other draws
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    const double u = ((double)(i % m) + a) / (double)m;
    const double v = ((double)(i / m) + b) / (double)m;
    return (point2){u < 1 ? u : 0.999999, v < 1 ? v : 0.999999};
}
