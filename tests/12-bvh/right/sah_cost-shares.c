// Right: shares of the area first.
#include "chapters/12-bvh/bvh.h"

real sah_cost(aabb box, int n_l, aabb l, int n_r, aabb r) {
    const real A = aabb_area(box), p_l = aabb_area(l) / A, p_r = aabb_area(r) / A;
    return C_STEP + C_HIT * (p_l * (real)n_l + p_r * (real)n_r);
}
