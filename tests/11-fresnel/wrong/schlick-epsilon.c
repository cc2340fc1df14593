// Wrong: an epsilon around eta = 1, where grazing light is still reflected.
// Expect: a boundary as weak as this one still reflects
#include "chapters/11-fresnel/fresnel.h"

real schlick(real cosine, real eta) {
    if (fabs(eta - 1) < (real)0.001) return 0;
    if (eta > 1) return schlick_slide(cosine, eta);
    const double c = cosine, e = eta, g2 = (e - 1) * (e + 1) + c * c;
    return g2 <= 0 ? 1 : schlick_slide((real)(sqrt(g2) / e), eta);
}
