// Wrong: the step for 1/|d|² in place of 1/|d|.
// Expect: the step for 1/|d|², not 1/|d|
#include "chapters/06-bounce/bounce.h"

vec3 keep_unit(vec3 d) {
    const real square = dot(d, d);
    if (!(fabs(square - 1) < (real)0.01)) return normalize(d);
    return scale(2 - square, d);
}
