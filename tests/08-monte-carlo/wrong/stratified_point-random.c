// Wrong: simply random.
// Expect: squares hold no point
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    return (point2){a + 0 * (double)(i + m), b};
}
