// Wrong: positive below the surface too.
// Expect: |cos θ| / π: below the surface
#include "chapters/10-importance-sampling/importance.h"

real cosine_probability(vec3 n, vec3 v) {
    return fabs(dot(n, v)) * (real)(1 / PI);
}
