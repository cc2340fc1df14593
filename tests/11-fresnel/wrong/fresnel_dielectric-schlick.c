// Wrong: Schlick's approximation in place of the exact formula.
// Expect: Schlick's approximation
#include "chapters/11-fresnel/fresnel.h"

real fresnel_dielectric(real cosine, real eta) {
    return schlick(cosine, eta);
}
