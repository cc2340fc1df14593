// Wrong: the sum is rounded to the nearest number, which may lie back where it came from.
// Expect: every component moves, in the direction of n
// Expect: And which way does a rounding go?
#include "chapters/06-bounce/bounce.h"

vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d) {
    const real reach = dot(absolute(n), error);
    return add(p, scale(dot(d, n) < 0 ? -reach : reach, n));
}
