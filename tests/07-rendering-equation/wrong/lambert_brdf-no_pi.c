// Wrong: the albedo itself, which reflects π times too much.
// Expect: rho: the directions of the hemisphere, weighted by the cosine, measure π
#include "chapters/07-rendering-equation/rendering.h"

double lambert_brdf(double rho) {
    return rho;
}
