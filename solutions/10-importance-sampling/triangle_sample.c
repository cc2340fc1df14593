#include "chapters/10-importance-sampling/importance.h"

// A uniform point of the parallelogram; the half beyond the diagonal is turned over onto the
// other: |1 - u|, |1 - v| there, and |0 - u|, |0 - v| before it, without a branch on what is
// chance. 1 - u is exact, u + v would be rounded.
triangle_point triangle_sample(triangle T, rng *g) {
    (void)T; // u and v are uniform for one triangle as for another
    const real u = rng_real(g);
    const real v = rng_real(g);
    const int turned = v > 1 - u; // 0 or 1
    return (triangle_point){0, fabs(turned - u), fabs(turned - v)};
}
