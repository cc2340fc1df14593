// Wrong: divided by 2π.
// Expect: cos θ / (2π): over the hemisphere
#include "chapters/10-importance-sampling/importance.h"

real cosine_probability(vec3 n, vec3 v) {
    return fmax(dot(n, v), 0) * (real)(0.5 / PI);
}
