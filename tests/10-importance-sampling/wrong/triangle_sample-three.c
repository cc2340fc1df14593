// Wrong: three random numbers divided by their sum: more in the middle.
// Expect: The middle is too full
#include "chapters/10-importance-sampling/importance.h"

triangle_point triangle_sample(triangle T, rng *g) {
    (void)T;
    const real a = rng_real(g);
    const real b = rng_real(g);
    const real c = rng_real(g);
    const real sum = a + b + c > 0 ? a + b + c : 1;
    return (triangle_point){0, a / sum, b / sum};
}
