// Wrong: the cosine without 1/π.
// Expect: the cosine without 1/π
#include "chapters/10-importance-sampling/importance.h"

real cosine_probability(vec3 n, vec3 v) {
    return fmax(dot(n, v), 0);
}
