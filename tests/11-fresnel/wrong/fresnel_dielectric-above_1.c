// Wrong: the sine by a root, which is NaN for a cosine that rounding took past 1.
// Expect: a rounding above 1
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    if (eta == 1) return 0;
    const double c = cosine, e = eta, sine = sqrt(1 - c * c) / e;
    if (sine >= 1) return 1;
    const double far = sqrt((1 - sine) * (1 + sine)), m = (e - 1) * (e + 1);
    const double rs = m / ((c + e * far) * (c + e * far));
    const double rp = (e * c - far) / (e * c + far);
    return (real)((rs * rs + rp * rp) / 2);
}
