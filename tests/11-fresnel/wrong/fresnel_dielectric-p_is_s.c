// Wrong: in r_p eta stands with the cosine of the far side, as in r_s.
// Expect: Is your r_p another r_s?
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    const double c = cosine, e = eta, cos2 = 1 - (1 - c * c) / (e * e);
    if (e == 1) return 0;
    if (cos2 <= 0) return 1;
    const double t = sqrt(cos2);
    const double s = (c - e * t) / (c + e * t), p = (e * t - c) / (e * t + c);
    return (real)((s * s + p * p) / 2);
}
