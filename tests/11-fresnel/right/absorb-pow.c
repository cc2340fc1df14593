// Right: a power of 1/e; sigma 0 apart by the product.
#include "chapters/11-fresnel/fresnel.h"

static real left(double sigma, double t) {
    const double way = sigma * t;
    return isnan(way) ? 1 : (real)pow(exp(-1.0), way);
}

color absorb(color sigma, real t) {
    return (color){left(sigma.x, t), left(sigma.y, t), left(sigma.z, t)};
}
