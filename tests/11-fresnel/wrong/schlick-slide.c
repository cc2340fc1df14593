// Wrong: the slide as it stands, total reflection and all.
// Expect: total reflection was forgotten, and the cosine is the inside one
// Expect: the cosine inside
#include "chapters/11-fresnel/fresnel.h"

real schlick(real cosine, real eta) {
    if (eta == 1) return 0;
    const real sine2 = (1 - cosine) * (1 + cosine) / (eta * eta);
    (void)sine2;
    const real c = cosine, r = (eta - 1) / (eta + 1), R0 = r * r;
    const real m = 1 - c;
    return R0 + (1 - R0) * (m * m * m * m * m);
}
