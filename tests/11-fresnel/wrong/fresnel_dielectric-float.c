// Wrong: the textbook formula in float: for eta near 1 it cancels.
// Expect: too few digits
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    const float c = (float)cosine, e = (float)eta, cos2 = 1 - (1 - c * c) / (e * e);
    if (e == 1) return 0;
    if (cos2 <= 0) return 1;
    const float t = sqrt(cos2);
    const float s = (c - e * t) / (c + e * t), p = (e * c - t) / (e * c + t);
    return (real)((s * s + p * p) / 2);
}
