// Wrong: twice as far as needed.
// Expect: twice the expected
#include "chapters/06-bounce/bounce.h"

vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d) {
    const vec3 m = dot(d, n) < 0 ? neg(n) : n;
    const vec3 q = add(p, scale(2 * dot(absolute(n), error), m));
    return (vec3){nextafter(q.x, m.x * NO_HIT), nextafter(q.y, m.y * NO_HIT),
                  nextafter(q.z, m.z * NO_HIT)};
}
