// Wrong: as on the slide: the sum may point into the surface.
// Expect: the bounce leaves the surface
#include "chapters/06-bounce/bounce.h"

vec3 fuzzy_bounce(vec3 d, vec3 n, real fuzz, rng *g) {
    return normalize(add(reflect(normalize(d), n), scale(fuzz, unit_vector(g))));
}
