// Wrong: uniform over the hemisphere.
// Expect: uniform over the hemisphere: the cosine is missing
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    return hemisphere_direction(n, g);
}
