// Wrong: the amplitudes are added, then squared.
// Expect: Each is squared first
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    if (eta == 1) return 0;
    const double c = cosine, e = eta, cos2 = 1 - (1 - c * c) / (e * e);
    if (cos2 <= 0) return 1;
    const double t = sqrt(cos2), rs = (c - e * t) / (c + e * t), rp = (e * c - t) / (e * c + t);
    return (real)((rs + rp) * (rs + rp) / 4);
}
