#include "chapters/06-bounce/bounce.h"

// One or two numbers further in the direction of the step, so that rounding
// p + step to the nearest never takes any of it back. (0 stays 0: a sum that is 0 is exact.)
static real away(real x, real direction) {
    const int sign = (direction > 0) - (direction < 0);
    return x + sign * (REAL_EPSILON * fabs(x));
}

// |n|·error is how far the box p ± error reaches along n.
vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d) {
    const vec3 m = dot(d, n) < 0 ? neg(n) : n;
    const vec3 q = add(p, scale(dot(absolute(n), error), m));
    return (vec3){away(q.x, m.x), away(q.y, m.y), away(q.z, m.z)};
}
