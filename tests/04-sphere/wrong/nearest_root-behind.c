// Wrong: the smaller root, also behind the eye.
// Expect: a root that is not above t_min
#include "chapters/04-sphere/sphere.h"

real nearest_root(roots q, real t_min, real t_max) {
    (void)t_min;
    if (q.count == 0) return NO_HIT;
    return q.t0 < t_max ? (real)q.t0 : NO_HIT;
}
