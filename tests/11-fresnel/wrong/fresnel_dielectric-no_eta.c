// Wrong: eta is missing from r_s.
// Expect: both cosines are there, but eta is missing from r_s
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    const double c = cosine, e = eta, cos2 = 1 - (1 - c * c) / (e * e);
    if (e == 1) return 0;
    if (cos2 <= 0) return 1;
    const double t = sqrt(cos2);
    const double s = (c - t) / (c + t), p = (e * c - t) / (e * c + t);
    return (real)((s * s + p * p) / 2);
}
