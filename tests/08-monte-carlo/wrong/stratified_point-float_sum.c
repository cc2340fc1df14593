// Wrong: column plus draw in float.
// Expect: the sum with the draw in double?
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const float a = (float)rng_double(g), b = (float)rng_double(g);
    const float u = (float)(i % m) + fminf(a, 0.9999999f),
                v = (float)(i / m) + fminf(b, 0.9999999f);
    return (point2){fmin((double)u / (double)m, 1 - DBL_EPSILON / 2),
                    fmin((double)v / (double)m, 1 - DBL_EPSILON / 2)};
}
