#include "chapters/10-importance-sampling/importance.h"

// A uniform point of the parallelogram; the half beyond the diagonal is turned over onto the
// other. 1 - u is exact, u + v would be rounded.
triangle_point triangle_sample(triangle T, rng *g) {
    (void)T; // u and v are uniform for one triangle as for another
    const real u = rng_real(g);
    const real v = rng_real(g);
    if (v > 1 - u) return (triangle_point){0, 1 - u, 1 - v};
    return (triangle_point){0, u, v};
}
