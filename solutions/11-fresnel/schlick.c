#include "chapters/11-fresnel/fresnel.h"

real schlick(real cosine, real eta) {
    if (eta == 1) return 0;
    if (eta > 1) return schlick_slide(cosine, eta);
    const real k = 1 - (1 - cosine) * (1 + cosine) / (eta * eta); // cos² of the far side
    return k <= 0 ? 1 : schlick_slide(sqrt(k), eta);
}
