// Wrong: the cosine inside, on the denser side.
// Expect: the cosine inside: Schlick's is the one on the less dense side
#include "chapters/11-fresnel/fresnel.h"

real schlick(real cosine, real eta) {
    if (eta == 1) return 0;
    const real sine2 = (1 - cosine) * (1 + cosine) / (eta * eta);
    if (eta < 1 && sine2 >= 1) return 1;
    const real c = cosine, r = (eta - 1) / (eta + 1), R0 = r * r;
    const real m = 1 - c;
    return R0 + (1 - R0) * (m * m * m * m * m);
}
