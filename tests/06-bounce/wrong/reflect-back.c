// Wrong: the formula for a d that points away from the surface.
// Expect: it goes back, since d points towards the surface
#include "chapters/06-bounce/bounce.h"

vec3 reflect(vec3 d, vec3 n) {
    return sub(scale(2 * dot(d, n), n), d);
}
