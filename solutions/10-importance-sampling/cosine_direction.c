#include "chapters/10-importance-sampling/importance.h"

// A uniform point of the disc, lifted to the hemisphere (Malley's method).
vec3 cosine_direction(vec3 n, rng *g) {
    real a, b, s;
    do {
        a = 2 * rng_real(g) - 1;
        b = 2 * rng_real(g) - 1;
        s = a * a + b * b;
    } while (s >= 1);
    return keep_unit(to_world(orthonormal_basis(n), (vec3){a, b, sqrt(1 - s)}));
}
