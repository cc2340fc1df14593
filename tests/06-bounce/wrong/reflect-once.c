// Wrong: the factor 2 is missing, and the ray slides along the surface.
// Expect: it slides along the surface; the 2 is missing
#include "chapters/06-bounce/bounce.h"

vec3 reflect(vec3 d, vec3 n) {
    return sub(d, scale(dot(d, n), n));
}
