// Wrong: along n, whatever side d is on.
// Expect: along n, whatever side d is on
#include "chapters/06-bounce/bounce.h"

vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d) {
    (void)d;
    return add(p, scale(dot(absolute(n), error), n));
}
