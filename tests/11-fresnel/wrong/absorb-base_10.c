// Wrong: chemists' base 10.
// Expect: 10^(-sigma t): chemists' base
#include "chapters/11-fresnel/fresnel.h"

static real left(double sigma, double t) {
    return sigma > 0 ? (real)pow(10, -sigma * t) : 1;
}

color absorb(color sigma, real t) {
    return (color){left(sigma.x, t), left(sigma.y, t), left(sigma.z, t)};
}
