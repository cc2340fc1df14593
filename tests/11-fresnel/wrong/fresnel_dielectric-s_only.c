// Wrong: r_s² alone.
// Expect: r_s² alone: unpolarised light is half r_s², half r_p²
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    const double c = cosine, e = eta, cos2 = 1 - (1 - c * c) / (e * e);
    if (e == 1) return 0;
    if (cos2 <= 0) return 1;
    const double t = sqrt(cos2);
    const double s = (c - e * t) / (c + e * t);
    return (real)((s * s));
}
