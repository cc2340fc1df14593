// Wrong: cos θ in place of 1 - cos θ.
// Expect: it is 1 - cos θ that counts
#include "chapters/11-fresnel/fresnel.h"

real schlick(real cosine, real eta) {
    if (eta == 1) return 0;
    const real sine2 = (1 - cosine) * (1 + cosine) / (eta * eta);
    if (eta < 1 && sine2 >= 1) return 1;
    const real c = eta < 1 ? sqrt(1 - sine2) : cosine, r = (eta - 1) / (eta + 1), R0 = r * r;
    const real m = c;
    return R0 + (1 - R0) * (m * m * m * m * m);
}
