// Wrong: the share that goes through.
// Expect: 1 - R: the share that goes through
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    const double c = cosine, e = eta, cos2 = 1 - (1 - c * c) / (e * e);
    if (e == 1) return 0;
    if (cos2 <= 0) return 1;
    const double t = sqrt(cos2);
    const double s = (c - e * t) / (c + e * t), p = (e * c - t) / (e * c + t);
    return (real)(1 - (s * s + p * p) / 2);
}
