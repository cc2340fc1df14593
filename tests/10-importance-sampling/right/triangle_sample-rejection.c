// Right: points of the parallelogram until one is in the triangle.
#include "chapters/10-importance-sampling/importance.h"

triangle_point triangle_sample(triangle T, rng *g) {
    (void)T;
    for (;;) {
        const real u = rng_real(g);
        const real v = rng_real(g);
        if (u + v <= 1) return (triangle_point){0, u, v};
    }
}
