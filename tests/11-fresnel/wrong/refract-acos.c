// Wrong: the cosine by way of the angle in real arithmetic: acos loses half the digits near 1.
// Expect: Which number is subtracted from a nearly equal one?
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {

    const float theta = acosf((float)fmin(-dot(d, n), 1)), sine = sinf(theta) / (float)eta;
    if (!(sine <= 1)) return false;
    const vec3 in_surface = scale(1 / eta, add(d, scale((real)cosf(theta), n)));
    *t = sub(in_surface, scale((real)sqrtf(1 - sine * sine), n));
    return true;
}
