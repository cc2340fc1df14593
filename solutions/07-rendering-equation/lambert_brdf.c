#include "chapters/07-rendering-equation/rendering.h"

double lambert_brdf(double rho) {
    return rho / PI;
}
