// Wrong: Newton's step without its half.
// Expect: the half is missing
#include "chapters/06-bounce/bounce.h"

vec3 keep_unit(vec3 d) {
    const real square = dot(d, d);
    if (!(fabs(square - 1) < sqrt(REAL_EPSILON) / 4)) return normalize(d);
    return scale(3 - square, d);
}
