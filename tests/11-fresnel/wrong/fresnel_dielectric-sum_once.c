// Wrong: r_s = m/(c + g), without the square.
// Expect: c + g stands there squared
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    const double c = cosine, m = ((double)eta - 1) * ((double)eta + 1), g2 = m + c * c;
    if (m == 0) return 0;
    if (g2 <= 0) return 1;
    const double g = sqrt(g2), sin2 = (1 - c) * (1 + c);
    const double rs = m / (c + g), q = (c * g - sin2) / (c * g + sin2);
    return (real)(rs * rs * (1 + q * q) / 2);
}
