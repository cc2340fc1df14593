// Right: the interval is tested before the division, and n is turned.
#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

real plane_hit(plane P, ray r, real t_min, real t_max) {
    double above = -wide_dot(wide_sub(r.O, P.x), widen(P.n));
    double along = wide_dot(widen(r.d), widen(P.n));
    if (along < 0) above = -above, along = -along;
    if (!(along > 0)) return NO_HIT;
    const real t = (real)(above / along);
    if (t <= t_min || t >= t_max) return NO_HIT;
    return t;
}
