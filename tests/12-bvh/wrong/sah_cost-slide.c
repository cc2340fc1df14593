// Wrong: as on the slide: not divided by A, no step.
// Expect: the slide's c alone
#include "chapters/12-bvh/bvh.h"

real sah_cost(aabb box, int n_l, aabb l, int n_r, aabb r) {
    const real hits = (real)n_l * aabb_area(l) + (real)n_r * aabb_area(r);
    (void)box;
    return hits;
}
