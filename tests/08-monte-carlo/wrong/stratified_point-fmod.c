// Wrong: what rounds to 1 becomes 0, by fmod.
// Expect: still in the last column and row, as with other draws
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    const double u = ((double)(i % m) + a) / (double)m;
    const double v = ((double)(i / m) + b) / (double)m;
    return (point2){fmod(u, 1), fmod(v, 1)};
}
