// Wrong: t is compared before it is rounded, and comes back equal to t_min.
// Expect: t is compared as it is returned
#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

real plane_hit(plane P, ray r, real t_min, real t_max) {
    const double along = wide_dot(widen(r.d), widen(P.n));
    if (along == 0) return NO_HIT;
    const double t = wide_dot(wide_sub(P.x, r.O), widen(P.n)) / along;
    return t > t_min && t < t_max ? (real)t : NO_HIT;
}
