// Wrong: Schlick's approximation.
// Expect: Schlick's approximation
#include "chapters/11-fresnel/fresnel.h"

color fresnel_conductor(real cosine, color eta, color k) {
    return schlick_conductor(cosine, eta, k);
}
