// Wrong: made longer by a fixed amount.
// Expect: The bound on the roundings is relative
#include "chapters/12-bvh/aabb.h"

#define LONGER ((real)1e-4)

bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    const real *side = &box->min.x;
    const real near_x = (side[r->near[0]] - r->O.x) * r->inverse.x,
               near_y = (side[r->near[1]] - r->O.y) * r->inverse.y,
               near_z = (side[r->near[2]] - r->O.z) * r->inverse.z;
    const real far_x = (side[r->far[0]] - r->O.x) * r->inverse.x,
               far_y = (side[r->far[1]] - r->O.y) * r->inverse.y,
               far_z = (side[r->far[2]] - r->O.z) * r->inverse.z;
    *enter =
        (1 - 2 * rounding_bound(4)) * greater(near_z, greater(near_y, greater(near_x, t_min)));
    return *enter <= lesser(far_z, lesser(far_y, lesser(far_x, t_max))) + LONGER;
}
