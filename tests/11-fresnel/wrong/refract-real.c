// Wrong: real arithmetic inside: cos² θ_t = 1 - sin² / eta² cancels.
// Expect: Which number is subtracted from a nearly equal one?
#include "chapters/11-fresnel/fresnel.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {
    const float c = -(float)dot(d, n), k = 1 - (1 - c) * (1 + c) / (float)(eta * eta);
    if (!(k >= 0)) return false;
    *t = keep_unit(add(scale(1 / eta, d), scale((real)(c / (float)eta - sqrtf(k)), n)));
    return true;
}
