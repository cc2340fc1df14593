// Wrong: red for all colours.
// Expect: red for all colours
#include "chapters/11-fresnel/fresnel.h"

color absorb(color sigma, real t) {
    const real left = sigma.x > 0 ? exp(-sigma.x * t) : 1;
    return (color){left, left, left};
}
