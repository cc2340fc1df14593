// Wrong: forgets t_max.
// Expect: a root that is not below t_max
// Expect: Only roots between t_min and t_max count
#include "chapters/04-sphere/sphere.h"

real nearest_root(roots q, real t_min, real t_max) {
    (void)t_max;
    if (q.count == 0) return NO_HIT;
    const real t0 = (real)q.t0, t1 = (real)q.t1;
    if (t0 > t_min) return t0;
    return t1 > t_min ? t1 : NO_HIT;
}
