// Wrong: e^(-sigma / t).
// Expect: the longer the way the more light
#include "chapters/11-fresnel/fresnel.h"

static real left(double sigma, double t) {
    return sigma > 0 ? (real)exp(-sigma / t) : 1;
}

color absorb(color sigma, real t) {
    return (color){left(sigma.x, t), left(sigma.y, t), left(sigma.z, t)};
}
