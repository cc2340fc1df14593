// Right: Cook and Torrance's form (1982), by g and c alone, in long double.
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    const long double c = cosine, e = eta, g2 = e * e - 1 + c * c;
    if (e == 1) return 0;
    if (g2 <= 0) return 1;
    const long double g = sqrtl(g2), s = (g - c) / (g + c);
    const long double p = (c * (g + c) - 1) / (c * (g - c) + 1);
    return (real)(s * s * (1 + p * p) / 2);
}
