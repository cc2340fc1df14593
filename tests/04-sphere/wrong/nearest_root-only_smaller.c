// Wrong: looks only at the smaller root, so that nothing is seen from inside.
// Expect: which of the two
// Expect: reported as a miss (NO_HIT)
// Expect: From outside, from inside, from behind
#include "chapters/04-sphere/sphere.h"

real nearest_root(roots q, real t_min, real t_max) {
    if (q.count == 0) return NO_HIT;
    const real t0 = (real)q.t0;
    return t0 > t_min && t0 < t_max ? t0 : NO_HIT;
}
