#include "chapters/06-bounce/bounce.h"

// Newton's step for 1 / |d| from the guess 1: a length of 1 + e becomes
// 1 - 3 e² / 2 - e³ / 2. Below this |e| the error left is far under a rounding.
vec3 keep_unit(vec3 d) {
    const real square = dot(d, d);
    const real near = sqrt(REAL_EPSILON) / 4;
    if (!(fabs(square - 1) < near)) return normalize(d);
    return scale((3 - square) / 2, d);
}
