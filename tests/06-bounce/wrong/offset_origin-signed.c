// Wrong: n·error with the signs of n, which cancel.
// Expect: n·error with the signs of n: they cancel
#include "chapters/06-bounce/bounce.h"

vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d) {
    const real reach = dot(n, error);
    return add(p, scale(dot(d, n) < 0 ? -reach : reach, n));
}
