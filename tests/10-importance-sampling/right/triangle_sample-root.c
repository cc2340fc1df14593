// Right: strips of u by the root, v evenly along the strip.
#include "chapters/10-importance-sampling/importance.h"

triangle_point triangle_sample(triangle T, rng *g) {
    (void)T;
    const real root = sqrt(rng_real(g));
    const real share = rng_real(g);
    return (triangle_point){0, 1 - root, share * root};
}
