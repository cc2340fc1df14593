// Wrong: times π, not divided by it.
// Expect: rho times π
#include "chapters/07-rendering-equation/rendering.h"

double lambert_brdf(double rho) {
    return rho * PI;
}
