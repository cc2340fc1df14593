// Wrong: a generator that lives from call to call: every run of the threads is another picture.
// Expect: numbers that do not come from g
#include "chapters/10-importance-sampling/importance.h"

triangle_point triangle_sample(triangle T, rng *g) {
    static rng own = {1, 3};
    (void)T, (void)g;
    const real u = rng_real(&own);
    const real v = rng_real(&own);
    return v > 1 - u ? (triangle_point){0, 1 - u, 1 - v} : (triangle_point){0, u, v};
}
