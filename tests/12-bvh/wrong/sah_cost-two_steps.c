// Wrong: C_step for each of the two boxes.
// Expect: C_step twice: it is for the pair of boxes
#include "chapters/12-bvh/bvh.h"

real sah_cost(aabb box, int n_l, aabb l, int n_r, aabb r) {
    const real hits = (real)n_l * aabb_area(l) + (real)n_r * aabb_area(r);
    return 2 * C_STEP + C_HIT * hits / aabb_area(box);
}
