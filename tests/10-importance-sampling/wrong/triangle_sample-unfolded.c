// Wrong: u and v of the whole parallelogram.
// Expect: u + v <= 1: beyond it lies the other half
// Expect: as in the whole parallelogram
#include "chapters/10-importance-sampling/importance.h"

triangle_point triangle_sample(triangle T, rng *g) {
    (void)T;
    const real a = rng_real(g);
    const real b = rng_real(g);
    return (triangle_point){0, a, b};
}
