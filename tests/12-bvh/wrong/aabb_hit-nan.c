// Wrong: what is NaN takes the place of what was known.
// Expect: In a face 0 · infinity is NaN
#include "chapters/12-bvh/aabb.h"

#define EARLIER (1 - 2 * rounding_bound(4))

bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    const real *side = &box->min.x;
    const real near_x = (side[r->near[0]] - r->O.x) * r->inverse.x,
               near_y = (side[r->near[1]] - r->O.y) * r->inverse.y,
               near_z = (side[r->near[2]] - r->O.z) * r->inverse.z;
    const real far_x = (side[r->far[0]] - r->O.x) * r->inverse.x,
               far_y = (side[r->far[1]] - r->O.y) * r->inverse.y,
               far_z = (side[r->far[2]] - r->O.z) * r->inverse.z;
    *enter = EARLIER * greater(greater(greater(t_min, near_x), near_y), near_z);
    return *enter <= lesser(lesser(lesser(t_max, far_x), far_y), far_z);
}
