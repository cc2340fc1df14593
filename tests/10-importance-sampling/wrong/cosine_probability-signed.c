// Wrong: negative below the surface.
// Expect: below the surface there are no draws
#include "chapters/10-importance-sampling/importance.h"

real cosine_probability(vec3 n, vec3 v) {
    return dot(n, v) * (real)(1 / PI);
}
