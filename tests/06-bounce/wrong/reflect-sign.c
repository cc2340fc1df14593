// Wrong: the part along n is added, not taken away.
// Expect: d + 2 (d·n) n: the sign
#include "chapters/06-bounce/bounce.h"

vec3 reflect(vec3 d, vec3 n) {
    return add(d, scale(2 * dot(d, n), n));
}
