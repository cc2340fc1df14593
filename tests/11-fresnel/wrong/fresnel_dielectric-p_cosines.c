// Wrong: r_p with eta at the wrong cosine.
// Expect: r_p with eta at the wrong cosine
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    if (eta == 1) return 0;
    const double c = cosine, e = eta, cos2 = 1 - (1 - c * c) / (e * e);
    if (cos2 <= 0) return 1;
    const double t = sqrt(cos2), rs = (c - e * t) / (c + e * t), rp = (t - e * c) / (e * t + c);
    return (real)((rs * rs + rp * rp) / 2);
}
