// Wrong: the row too is the remainder: only squares on the diagonal.
// Expect: squares hold no point
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    return (point2){fmin(((double)(i % m) + a) / (double)m, 0.999),
                    fmin(((double)(i % m) + b) / (double)m, 0.999)};
}
