#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

// A parallel ray has along = 0: t is infinite or not a number, and lies in no interval.
real plane_hit(plane P, ray r, real t_min, real t_max) {
    const double above = wide_dot(wide_sub(P.x, r.O), widen(P.n));
    const double along = wide_dot(widen(r.d), widen(P.n));
    const real t = (real)(above / along);
    return t < t_max && t > t_min ? t : NO_HIT;
}
