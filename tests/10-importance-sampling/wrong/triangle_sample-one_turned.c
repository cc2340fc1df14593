// Wrong: beyond the diagonal only u is turned.
// Expect: u + v <= 1: beyond it lies the other half
// Expect: or only in one coordinate
// Expect: both u and v change
#include "chapters/10-importance-sampling/importance.h"

triangle_point triangle_sample(triangle T, rng *g) {
    (void)T;
    const real u = rng_real(g);
    const real v = rng_real(g);
    return (triangle_point){0, v > 1 - u ? 1 - u : u, v};
}
