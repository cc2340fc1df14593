// Wrong: divided by the solid angle of the hemisphere, without the cosine.
// Expect: rho / 2π: the hemisphere's solid angle, without the cosine
#include "chapters/07-rendering-equation/rendering.h"

double lambert_brdf(double rho) {
    return rho / (2 * PI);
}
