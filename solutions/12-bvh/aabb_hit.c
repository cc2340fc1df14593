#include "chapters/12-bvh/aabb.h"

// A NaN, infinity less infinity, loses every comparison, and then what was known before stays:
// that side sets no limit. So the order in `greater` and `lesser` matters.
inline bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    const real *side = &box->min.x;
    const real near_x = times_plus(side[r->near[0]], r->near_scale.x, r->near_offset.x),
               near_y = times_plus(side[r->near[1]], r->near_scale.y, r->near_offset.y),
               near_z = times_plus(side[r->near[2]], r->near_scale.z, r->near_offset.z);
    const real far_x = times_plus(side[r->far[0]], r->far_scale.x, r->far_offset.x),
               far_y = times_plus(side[r->far[1]], r->far_scale.y, r->far_offset.y),
               far_z = times_plus(side[r->far[2]], r->far_scale.z, r->far_offset.z);
    *enter = greater(near_z, greater(near_y, greater(near_x, t_min)));
    return *enter <= lesser(far_z, lesser(far_y, lesser(far_x, t_max)));
}
