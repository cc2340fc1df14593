// Wrong: a threshold against parallel rays throws away every hit of a short d.
// Expect: only d·n == 0, exactly, is parallel
// Expect: only d·n == 0, exactly, is parallel, whatever
#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

real plane_hit(plane P, ray r, real t_min, real t_max) {
    const double along = wide_dot(widen(r.d), widen(P.n));
    if (fabs(along) < 1e-6) return NO_HIT;
    const real t = (real)(wide_dot(wide_sub(P.x, r.O), widen(P.n)) / along);
    return t > t_min && t < t_max ? t : NO_HIT;
}
