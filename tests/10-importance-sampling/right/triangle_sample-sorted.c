// Right: the two gaps of two sorted random numbers.
#include "chapters/10-importance-sampling/importance.h"

triangle_point triangle_sample(triangle T, rng *g) {
    (void)T;
    const real a = rng_real(g);
    const real b = rng_real(g);
    return (triangle_point){0, fmin(a, b), fabs(a - b)};
}
