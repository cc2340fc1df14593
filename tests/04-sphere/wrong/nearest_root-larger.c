// Wrong: takes the larger root, where the ray leaves the sphere.
// Expect: looks like the larger root
#include "chapters/04-sphere/sphere.h"

real nearest_root(roots q, real t_min, real t_max) {
    if (q.count == 0) return NO_HIT;
    const real t0 = (real)q.t0, t1 = (real)q.t1;
    if (t1 > t_min && t1 < t_max) return t1;
    if (t0 > t_min && t0 < t_max) return t0;
    return NO_HIT;
}
