#include "chapters/06-bounce/bounce.h"

static real away(real x, real direction) {
    if (direction == 0) return x;
    return nextafter(x, direction > 0 ? REAL_MAX : -REAL_MAX);
}

vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d) {
    const real side = dot(d, n) < 0 ? -1 : 1;
    const vec3 step = scale(side * dot(absolute(n), error), n);
    const vec3 q = add(p, step);
    return (vec3){away(q.x, step.x), away(q.y, step.y), away(q.z, step.z)};
}
