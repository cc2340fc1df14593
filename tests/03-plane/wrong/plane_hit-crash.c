// Wrong: reads through a null pointer.
// Expect: crashed: bad pointer?
#include "chapters/03-plane/plane.h"

static const plane *volatile nowhere = NULL;

real plane_hit(plane P, ray r, real t_min, real t_max) {
    (void)P;
    const real t = (nowhere->x.y - r.O.y) / r.d.y;
    return t > t_min && t < t_max ? t : NO_HIT;
}
