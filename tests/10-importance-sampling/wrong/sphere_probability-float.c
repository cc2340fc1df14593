// Wrong: the cone in real arithmetic: d² - r² cancels close to the sphere.
// Expect: close to the sphere it cancels
#include "chapters/10-importance-sampling/importance.h"

real sphere_probability(sphere S, vec3 x, vec3 v) {
    const vec3 w = sub(S.c, x), side = cross(w, v);
    const real sin2 = S.r * S.r / dot(w, w);
    if (!(sin2 < 1) || dot(w, v) <= 0 || dot(side, side) > S.r * S.r) return 0;
    return (1 + sqrt(1 - sin2)) / ((real)(2 * PI) * sin2);
}
