// Wrong: t < 0 is kept, so that what lies behind the eye is seen.
// Expect: a hit was reported where there is none
// Expect: The plane lies behind the eye
#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

real plane_hit(plane P, ray r, real t_min, real t_max) {
    (void)t_min;
    const double along = wide_dot(widen(r.d), widen(P.n));
    if (along == 0) return NO_HIT;
    const real t = (real)(wide_dot(wide_sub(P.x, r.O), widen(P.n)) / along);
    return t < t_max ? t : NO_HIT;
}
