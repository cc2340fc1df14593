#include "chapters/10-importance-sampling/importance.h"

real sphere_probability(sphere S, vec3 x, vec3 v) {
    const vec3 w = sub(S.c, x);
    const real sin2 = S.r * S.r / dot(w, w);
    if (!(sin2 < 1)) return 0;
    const vec3 side = cross(w, v);
    if (dot(w, v) <= 0 || dot(side, side) > S.r * S.r) return 0;
    return (1 + sqrt(1 - sin2)) / ((real)(2 * PI) * sin2);
}
