#include "chapters/12-bvh/aabb.h"

// A NaN, infinity less infinity, loses every comparison, and then what was known before stays:
// that side sets no limit. So the order in `greater` and `lesser` matters.
bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    const real *side = &box->min.x;
    for (int axis = 0; axis < 3; axis++) {
        const real in =
            times_plus(side[r->near[axis]], r->near_scale[axis], r->near_offset[axis]);
        const real out =
            times_plus(side[r->far[axis]], r->far_scale[axis], r->far_offset[axis]);
        t_min = greater(in, t_min);
        t_max = lesser(out, t_max);
    }
    *enter = t_min;
    return t_min <= t_max;
}
