#include "chapters/11-fresnel/fresnel.h"

real schlick(real cosine, real eta) {
    if (eta == 1) return 0;
    if (eta > 1) return schlick_slide(cosine, eta);
    const double c = cosine, e = eta, g2 = (e - 1) * (e + 1) + c * c; // (eta cos θ_t)²
    return g2 <= 0 ? 1 : schlick_slide((real)(sqrt(g2) / e), eta);
}
