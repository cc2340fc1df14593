// Wrong: parallel within an epsilon of the lengths of d and n.
// Expect: only d·n == 0, exactly, is parallel, whatever it is measured by
#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

real plane_hit(plane P, ray r, real t_min, real t_max) {
    const wide3 n = widen(P.n), d = widen(r.d);
    const double above = wide_dot(wide_sub(P.x, r.O), n), along = wide_dot(d, n);
    if (fabs(along) < DBL_EPSILON * sqrt(wide_dot(d, d) * wide_dot(n, n))) return NO_HIT;
    const real t = (real)(above / along);
    return t < t_max && t > t_min ? t : NO_HIT;
}
