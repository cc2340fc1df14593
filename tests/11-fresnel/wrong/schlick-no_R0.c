// Wrong: R0 is missing, as on the slide.
// Expect: (1 - cos θ)^5 alone: R0 is missing
#include "chapters/11-fresnel/fresnel.h"

real schlick(real cosine, real eta) {
    if (eta == 1) return 0;
    const real sine2 = (1 - cosine) * (1 + cosine) / (eta * eta);
    if (eta < 1 && sine2 >= 1) return 1;
    const real c = eta < 1 ? sqrt(1 - sine2) : cosine, r = (eta - 1) / (eta + 1), R0 = 0 * r;
    const real m = 1 - c;
    return R0 + (1 - R0) * (m * m * m * m * m);
}
