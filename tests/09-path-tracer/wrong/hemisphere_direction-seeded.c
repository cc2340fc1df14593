// Wrong: a freshly seeded generator in place of g.
// Expect: all draws are alike: is g used?
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    (void)g;
    rng mine = rng_seed(1, 1);
    const vec3 v = unit_vector(&mine);
    return dot(v, n) < 0 ? neg(v) : v;
}
