// Wrong: |d·n| in place of d·n, so that one side of the surface mirrors wrongly.
// Expect: What must happen to the part of d along n
#include "chapters/06-bounce/bounce.h"

vec3 reflect(vec3 d, vec3 n) {
    return add(d, scale(2 * fabs(dot(d, n)), n));
}
