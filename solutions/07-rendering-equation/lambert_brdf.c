#include "chapters/07-rendering-equation/rendering.h"

// The hemisphere's directions, weighted by the cosine, measure π.
double lambert_brdf(double rho) {
    return rho / PI;
}
