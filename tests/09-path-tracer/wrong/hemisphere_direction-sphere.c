// Wrong: the whole sphere: half of the directions go into the surface.
// Expect: Half of them: the whole sphere
// Expect: uniform over the whole sphere
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    (void)n;
    return unit_vector(g);
}
