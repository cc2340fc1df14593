// Right: in real arithmetic.
#include "chapters/11-fresnel/fresnel.h"

color absorb(color sigma, real t) {
    const vec3 way = scale(-t, sigma);
    return (color){sigma.x > 0 ? exp(way.x) : 1, sigma.y > 0 ? exp(way.y) : 1,
                   sigma.z > 0 ? exp(way.z) : 1};
}
