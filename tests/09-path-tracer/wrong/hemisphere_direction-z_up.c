// Wrong: above the plane z = 0, whatever n is.
// Expect: every direction leaves the surface
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    (void)n;
    const vec3 v = unit_vector(g);
    return v.z < 0 ? neg(v) : v;
}
