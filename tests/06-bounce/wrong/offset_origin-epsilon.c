// Wrong: a fixed distance along n, whatever the error is.
// Expect: the start lies
#include "chapters/06-bounce/bounce.h"

vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d) {
    (void)error;
    return add(p, scale(dot(d, n) < 0 ? (real)-1e-4 : (real)1e-4, n));
}
