// Wrong: 1 - sigma t.
// Expect: 1 - sigma t: right for short ways only
#include "chapters/11-fresnel/fresnel.h"

static real left(double sigma, double t) {
    return sigma > 0 ? (real)(1 - sigma * t) : 1;
}

color absorb(color sigma, real t) {
    return (color){left(sigma.x, t), left(sigma.y, t), left(sigma.z, t)};
}
