// Wrong: the density of the uniform hemisphere.
// Expect: 1/(2π): uniform over the hemisphere
#include "chapters/10-importance-sampling/importance.h"

real cosine_probability(vec3 n, vec3 v) {
    return dot(n, v) > 0 ? (real)(0.5 / PI) : 0;
}
