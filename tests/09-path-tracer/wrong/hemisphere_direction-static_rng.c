// Wrong: a generator that lives from call to call: every run of the threads is another picture.
// Expect: numbers that do not come from g
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    static rng own = {1, 3};
    (void)g;
    const vec3 v = unit_vector(&own);
    return dot(v, n) < 0 ? neg(v) : v;
}
