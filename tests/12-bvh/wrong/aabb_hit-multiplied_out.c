// Wrong: box / d - O / d: the difference magnifies the roundings of both.
// Expect: no rounding may be magnified
#include "chapters/12-bvh/aabb.h"

#define EARLIER (1 - 2 * rounding_bound(4))

bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    const real *side = &box->min.x;
    const real near_x = (r->d.x == 0 ? (side[r->near[0]] - r->O.x) * r->inverse.x
                                     : side[r->near[0]] * r->inverse.x - r->O.x * r->inverse.x),
               near_y = (r->d.y == 0 ? (side[r->near[1]] - r->O.y) * r->inverse.y
                                     : side[r->near[1]] * r->inverse.y - r->O.y * r->inverse.y),
               near_z = (r->d.z == 0 ? (side[r->near[2]] - r->O.z) * r->inverse.z
                                     : side[r->near[2]] * r->inverse.z - r->O.z * r->inverse.z);
    const real far_x = (r->d.x == 0 ? (side[r->far[0]] - r->O.x) * r->inverse.x
                                    : side[r->far[0]] * r->inverse.x - r->O.x * r->inverse.x),
               far_y = (r->d.y == 0 ? (side[r->far[1]] - r->O.y) * r->inverse.y
                                    : side[r->far[1]] * r->inverse.y - r->O.y * r->inverse.y),
               far_z = (r->d.z == 0 ? (side[r->far[2]] - r->O.z) * r->inverse.z
                                    : side[r->far[2]] * r->inverse.z - r->O.z * r->inverse.z);
    *enter = EARLIER * greater(near_z, greater(near_y, greater(near_x, t_min)));
    return *enter <= lesser(far_z, lesser(far_y, lesser(far_x, t_max)));
}
