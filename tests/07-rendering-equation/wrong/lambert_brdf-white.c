// Wrong: the same for every albedo.
// Expect: 1 / π: it does not depend on rho
#include "chapters/07-rendering-equation/rendering.h"

double lambert_brdf(double rho) {
    (void)rho;
    return 1 / PI;
}
