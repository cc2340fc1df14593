// Wrong: v from the draw of u, mirrored.
// Expect: u and v come from one draw
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = 1 - a;
    const double u = ((double)(i % m) + a) / (double)m;
    const double v = ((double)(i / m) + b) / (double)m;
    return (point2){fmin(u, 1 - DBL_EPSILON / 2), fmin(v, 1 - DBL_EPSILON / 2)};
}
