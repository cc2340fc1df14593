// Wrong: the way is missing.
// Expect: e^(-sigma): the way t is missing
#include "chapters/11-fresnel/fresnel.h"

static real left(double sigma, double t) {
    return t > 0 ? (real)exp(-sigma) : 1;
}

color absorb(color sigma, real t) {
    return (color){left(sigma.x, t), left(sigma.y, t), left(sigma.z, t)};
}
