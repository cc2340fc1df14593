#include "chapters/11-fresnel/fresnel.h"

static real left(real sigma, real t) {
    return sigma > 0 ? exp(-sigma * t) : 1;
}

color absorb(color sigma, real t) {
    return (color){left(sigma.x, t), left(sigma.y, t), left(sigma.z, t)};
}
