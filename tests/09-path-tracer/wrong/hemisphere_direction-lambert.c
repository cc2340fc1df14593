// Wrong: Lambert's bounce of chapter 06: the density cos θ / π.
// Expect: Lambert's bounce of chapter 06, not uniform
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    return matte_bounce(n, g);
}
