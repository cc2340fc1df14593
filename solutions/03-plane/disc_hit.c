#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

real disc_hit(disc D, ray r, real t_min, real t_max) {
    const real t = plane_hit(D.P, r, t_min, t_max);
    if (t == NO_HIT || !(D.radius > 0)) return NO_HIT;
    const wide3 from_centre = wide_along(wide_sub(r.O, D.P.x), t, widen(r.d));
    return wide_dot(from_centre, from_centre) <= (double)D.radius * D.radius ? t : NO_HIT;
}
