// Wrong: the square that holds the centre, not the mean.
// Expect: Average each wave, then multiply.
#include "chapters/03-plane/plane.h"

real checks_average(real x, real z, real w) {
    (void)w;
    return checks(x, z);
}
