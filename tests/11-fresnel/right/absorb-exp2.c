// Right: as a power of 2.
#include "chapters/11-fresnel/fresnel.h"

static real left(double sigma, double t) {
    return sigma > 0 ? (real)exp2(-sigma * t / log(2)) : 1;
}

color absorb(color sigma, real t) {
    return (color){left(sigma.x, t), left(sigma.y, t), left(sigma.z, t)};
}
