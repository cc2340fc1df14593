// Wrong: a closed interval, so a ray hits the surface that it starts on.
// Expect: Both ends are excluded.
#include "chapters/04-sphere/sphere.h"

real nearest_root(roots q, real t_min, real t_max) {
    if (q.count == 0) return NO_HIT;
    const real t0 = (real)q.t0, t1 = (real)q.t1;
    if (t0 >= t_min && t0 <= t_max) return t0;
    if (t1 >= t_min && t1 <= t_max) return t1;
    return NO_HIT;
}
