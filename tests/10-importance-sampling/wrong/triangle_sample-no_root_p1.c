// Wrong: u = a b and v = a (1 - b), without the root of a.
// Expect: too many points near p1, where u = v = 0: a root is missing
#include "chapters/10-importance-sampling/importance.h"

triangle_point triangle_sample(triangle T, rng *g) {
    (void)T;
    const real a = rng_real(g);
    const real b = rng_real(g);
    return (triangle_point){0, a * b, a * (1 - b)};
}
