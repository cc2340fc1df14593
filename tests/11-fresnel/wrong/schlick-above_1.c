// Wrong: the angle by acos, which is NaN for a cosine that rounding took past 1.
// Expect: a rounding above 1
#include "chapters/11-fresnel/fresnel.h"

real schlick(real cosine, real eta) {
    if (eta == 1) return 0;
    const double theta = acos((double)cosine), far = sin(theta) / (double)eta;
    if (far >= 1) return 1;
    return schlick_slide(eta > 1 ? (real)cos(theta) : (real)sqrt((1 - far) * (1 + far)), eta);
}
