// Wrong: m - 1 plus nearly 1 is rounded to m.
// Expect: never 1: m - 1 + draw is rounded, and to what?
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    return (point2){((double)(i % m) + a) / (double)m, ((double)(i / m) + b) / (double)m};
}
