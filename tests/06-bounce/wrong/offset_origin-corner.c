// Wrong: to the corner of the box, not along n.
// Expect: to the corner of the box
#include "chapters/06-bounce/bounce.h"

vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d) {
    const vec3 m = dot(d, n) < 0 ? neg(n) : n;
    return (vec3){p.x + copysign(error.x, m.x), p.y + copysign(error.y, m.y),
                  p.z + copysign(error.z, m.z)};
}
