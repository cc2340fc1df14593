// Wrong: the cosine of the less dense side by sin θ_t = eta sin θ.
// Expect: cos θ_t with eta upside down
#include "chapters/11-fresnel/fresnel.h"

real schlick(real cosine, real eta) {
    if (eta == 1) return 0;
    if (eta > 1) return schlick_slide(cosine, eta);
    const double c = cosine, e = eta, cos2 = 1 - (1 - c * c) * e * e;
    return cos2 <= 0 ? 1 : schlick_slide((real)sqrt(cos2), eta);
}
