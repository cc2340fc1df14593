// Wrong: a generator that lives from call to call.
// Expect: numbers that do not come from g
#include "chapters/08-monte-carlo/monte_carlo.h"

// m - 1 + a draw just below 1 rounds to m, and u to 1.
static double place(long square, double draw, long m) {
    return fmin(((double)square + draw) / (double)m, 1 - DBL_EPSILON / 2);
}

point2 stratified_point(long i, long m, rng *caller) {
    static rng own = {1, 3}, *const g = &own;
    (void)caller;
    const double a = rng_double(g), b = rng_double(g);
    return (point2){place(i % m, a, m), place(i / m, b, m)};
}
