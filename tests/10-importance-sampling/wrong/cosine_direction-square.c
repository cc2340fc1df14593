// Wrong: points of the square, not of the disc, lifted.
// Expect: finite, no NaN
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    const real a = 2 * rng_real(g) - 1;
    const real b = 2 * rng_real(g) - 1;
    return to_world(orthonormal_basis(n), (vec3){a, b, sqrt(1 - a * a - b * b)});
}
