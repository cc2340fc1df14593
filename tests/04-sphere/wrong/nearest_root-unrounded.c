// Wrong: compares the double and returns it rounded, which may be t_min itself.
// Expect: compared as it is returned
// Expect: a root above t_min, but t_min itself once rounded
#include "chapters/04-sphere/sphere.h"

real nearest_root(roots q, real t_min, real t_max) {
    if (q.count == 0) return NO_HIT;
    if (q.t0 > t_min && q.t0 < t_max) return (real)q.t0;
    if (q.t1 > t_min && q.t1 < t_max) return (real)q.t1;
    return NO_HIT;
}
