// Wrong: the counts are exchanged.
// Expect: the counts exchanged: n_l belongs to l
#include "chapters/12-bvh/bvh.h"

real sah_cost(aabb box, int n_l, aabb l, int n_r, aabb r) {
    const real hits = (real)n_r * aabb_area(l) + (real)n_l * aabb_area(r);
    return C_STEP + C_HIT * hits / aabb_area(box);
}
