// Wrong: the cosine of the far side is taken for the one of this side.
// Expect: the cosine of the wrong side
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    const double c = cosine, e = eta, cos2 = 1 - (1 - c * c) / (e * e);
    if (e == 1) return 0;
    if (cos2 <= 0) return 1;
    const double f = sqrt(cos2), t = sqrt(fmax(1 - (1 - cos2) / (e * e), 0));
    const double s = (f - e * t) / (f + e * t), p = (e * f - t) / (e * f + t);
    return (real)((s * s + p * p) / 2);
}
