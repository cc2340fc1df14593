// Wrong: what is absorbed, not what is left.
// Expect: what is absorbed, not what is left
#include "chapters/11-fresnel/fresnel.h"

static real left(double sigma, double t) {
    return sigma > 0 ? (real)(1 - exp(-sigma * t)) : 1;
}

color absorb(color sigma, real t) {
    return (color){left(sigma.x, t), left(sigma.y, t), left(sigma.z, t)};
}
