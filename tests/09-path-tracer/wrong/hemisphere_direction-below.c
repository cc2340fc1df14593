// Wrong: the sign is turned round where it was right.
// Expect: every direction leaves the surface
// Expect: which sign is turned round?
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    const vec3 v = unit_vector(g);
    return dot(v, n) > 0 ? neg(v) : v;
}
