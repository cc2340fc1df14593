// Wrong: one draw for both coordinates: points on the squares' diagonals.
// Expect: Somewhere in the square: two draws from g
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    const double a = rng_double(g), b = rng_double(g);
    return (point2){((double)(i % m) + a) / (double)m,
                    ((double)(i / m) + a) / (double)m + 0 * b};
}
