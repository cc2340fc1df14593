#include "chapters/06-bounce/bounce.h"

// One or two numbers further in the direction of the step, so that rounding
// p + step to the nearest never takes any of it back.
static real away(real x, real step) {
    const int sign = (step > 0) - (step < 0);
    return x + sign * (REAL_EPSILON * fabs(x));
}

// |n|·error is how far the box p ± error reaches along n.
vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d) {
    const real reach = dot(absolute(n), error);
    const vec3 step = scale(dot(d, n) < 0 ? -reach : reach, n);
    const vec3 q = add(p, step);
    return (vec3){away(q.x, step.x), away(q.y, step.y), away(q.z, step.z)};
}
