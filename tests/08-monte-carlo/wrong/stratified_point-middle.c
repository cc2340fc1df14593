// Wrong: the middle of each square: a grid.
// Expect: all lie at the same place in their squares
#include "chapters/08-monte-carlo/monte_carlo.h"

point2 stratified_point(long i, long m, rng *g) {
    (void)g;
    return (point2){((double)(i % m) + 0.5) / (double)m, ((double)(i / m) + 0.5) / (double)m};
}
