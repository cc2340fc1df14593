// Wrong: the square of the distance compared with the radius.
// Expect: How far is O + t d from the centre?
#include "chapters/03-plane/plane.h"
#include "common/wide3.h"

real disc_hit(disc D, ray r, real t_min, real t_max) {
    const real t = plane_hit(D.P, r, t_min, t_max);
    if (t == NO_HIT || !(D.radius > 0)) return NO_HIT;
    const wide3 v = wide_along(wide_sub(r.O, D.P.x), t, widen(r.d));
    return wide_dot(v, v) <= (double)D.radius ? t : NO_HIT;
}
