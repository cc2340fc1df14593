// Wrong: v in what u left, without the root.
// Expect: a root is missing
#include "chapters/10-importance-sampling/importance.h"

triangle_point triangle_sample(triangle T, rng *g) {
    (void)T;
    const real a = rng_real(g);
    const real b = rng_real(g);
    return (triangle_point){0, a, b * (1 - a)};
}
