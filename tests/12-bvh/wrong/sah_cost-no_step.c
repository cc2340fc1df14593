// Wrong: C_step is missing.
// Expect: C_step is missing
#include "chapters/12-bvh/bvh.h"

real sah_cost(aabb box, int n_l, aabb l, int n_r, aabb r) {
    const real hits = (real)n_l * aabb_area(l) + (real)n_r * aabb_area(r);
    return C_HIT * hits / aabb_area(box);
}
