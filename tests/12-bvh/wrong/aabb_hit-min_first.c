// Wrong: min comes first, also where d is negative.
// Expect: Where d is negative, max comes first
#include "chapters/12-bvh/aabb.h"

#define EARLIER (1 - 2 * rounding_bound(4))

bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    const real near_x = (box->min.x - r->O.x) * r->inverse.x,
               near_y = (box->min.y - r->O.y) * r->inverse.y,
               near_z = (box->min.z - r->O.z) * r->inverse.z;
    const real far_x = (box->max.x - r->O.x) * r->inverse.x,
               far_y = (box->max.y - r->O.y) * r->inverse.y,
               far_z = (box->max.z - r->O.z) * r->inverse.z;
    *enter = EARLIER * greater(near_z, greater(near_y, greater(near_x, t_min)));
    return *enter <= lesser(far_z, lesser(far_y, lesser(far_x, t_max)));
}
