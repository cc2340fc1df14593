#include "chapters/11-fresnel/fresnel.h"

// sigma = 0 apart: 0 times infinity is not a number.
static real left(double sigma, double t) {
    return sigma > 0 ? (real)exp(-sigma * t) : 1;
}

color absorb(color sigma, real t) {
    return (color){left(sigma.x, t), left(sigma.y, t), left(sigma.z, t)};
}
