#include "chapters/10-importance-sampling/importance.h"

// A uniform point of the parallelogram, folded over its diagonal.
triangle_point triangle_sample(triangle T, rng *g) {
    (void)T;
    const real u = rng_real(g);
    const real v = rng_real(g);
    if (u + v > 1) return (triangle_point){0, 1 - u, 1 - v};
    return (triangle_point){0, u, v};
}
