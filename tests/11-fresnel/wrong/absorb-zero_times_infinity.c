// Wrong: 0 · ∞ in a clear medium without end.
// Expect: NaN
#include "chapters/11-fresnel/fresnel.h"

static real left(double sigma, double t) {
    return (real)exp(-sigma * t);
}

color absorb(color sigma, real t) {
    return (color){left(sigma.x, t), left(sigma.y, t), left(sigma.z, t)};
}
