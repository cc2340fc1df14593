// Wrong: the other half is shrunk into the triangle, not folded.
// Expect: was shrunk, not turned
#include "chapters/10-importance-sampling/importance.h"

triangle_point triangle_sample(triangle T, rng *g) {
    (void)T;
    const real a = rng_real(g);
    const real b = rng_real(g);
    if (a + b > 1) return (triangle_point){0, (1 - a) / 2, (1 - b) / 2};
    return (triangle_point){0, a, b};
}
