#include "chapters/10-importance-sampling/importance.h"

real cosine_probability(vec3 n, vec3 v) {
    const real cosine = dot(n, v);
    return cosine > 0 ? cosine * (real)(1 / PI) : 0;
}
