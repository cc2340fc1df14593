#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

// plane_hit's t is rounded, and far away that moves the point by more than the rim
// is sharp. So the distance is measured with t as it was before.
real disc_hit(disc D, ray r, real t_min, real t_max) {
    const real rounded = plane_hit(D.P, r, t_min, t_max);
    if (rounded == NO_HIT || !(D.radius > 0)) return NO_HIT;
    const wide3 n = widen(D.P.n), d = widen(r.d);
    const double t = wide_dot(wide_sub(D.P.x, r.O), n) / wide_dot(d, n);
    const wide3 from_centre = wide_along(wide_sub(r.O, D.P.x), t, d);
    return wide_dot(from_centre, from_centre) <= (double)D.radius * D.radius ? rounded : NO_HIT;
}
