// Wrong: O - x in place of x - O.
// Expect: looks like O - x in place of x - O
#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

real plane_hit(plane P, ray r, real t_min, real t_max) {
    const double along = wide_dot(widen(r.d), widen(P.n));
    if (along == 0) return NO_HIT;
    const real t = (real)(wide_dot(wide_sub(r.O, P.x), widen(P.n)) / along);
    return t > t_min && t < t_max ? t : NO_HIT;
}
