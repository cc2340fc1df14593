// Wrong: equal indices reflect.
// Expect: the slide's formula reflects where there is nothing
#include "chapters/11-fresnel/fresnel.h"

real schlick(real cosine, real eta) {
    const real sine2 = (1 - cosine) * (1 + cosine) / (eta * eta);
    if (eta < 1 && sine2 >= 1) return 1;
    const real c = eta < 1 ? sqrt(1 - sine2) : cosine, r = (eta - 1) / (eta + 1), R0 = r * r;
    const real m = 1 - c;
    return R0 + (1 - R0) * (m * m * m * m * m);
}
