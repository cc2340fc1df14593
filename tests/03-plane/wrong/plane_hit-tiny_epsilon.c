// Wrong: parallel within an epsilon, a very small one.
// Expect: only d·n == 0, exactly, is parallel
#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

real plane_hit(plane P, ray r, real t_min, real t_max) {
    const double above = wide_dot(wide_sub(P.x, r.O), widen(P.n));
    const double along = wide_dot(widen(r.d), widen(P.n));
    if (fabs(along) < 1e-20) return NO_HIT;
    const real t = (real)(above / along);
    return t < t_max && t > t_min ? t : NO_HIT;
}
