// Wrong: uses t0 and t1 although there are no roots.
// Expect: a hit was reported where there is none
// Expect: count says how many there are
#include "chapters/04-sphere/sphere.h"

real nearest_root(roots q, real t_min, real t_max) {
    const real t0 = (real)q.t0, t1 = (real)q.t1;
    if (t0 > t_min && t0 < t_max) return t0;
    if (t1 > t_min && t1 < t_max) return t1;
    return NO_HIT;
}
