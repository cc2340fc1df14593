// Wrong: u and v change places.
// Expect: are u and v exchanged?
#include "chapters/05-triangle/triangle.h"

vec3 smooth_normal(vec3 n1, vec3 n2, vec3 n3, real u, real v) {
    const vec3 n = add(add(scale(1 - u - v, n1), scale(v, n2)), scale(u, n3));
    return length(n) > 4 * REAL_EPSILON ? normalize(n) : n1; // shorter is rounding alone
}
