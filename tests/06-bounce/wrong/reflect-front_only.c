// Wrong: |d·n| in place of d·n, so that one side of the surface mirrors wrongly.
// Expect: d + 2 |d·n| n: right only where d·n < 0
#include "chapters/06-bounce/bounce.h"

vec3 reflect(vec3 d, vec3 n) {
    return add(d, scale(2 * fabs(dot(d, n)), n));
}
