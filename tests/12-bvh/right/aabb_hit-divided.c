// Right: divides, and orders the two ends of each slab by size; d = 0 is a case of its own.
#include "chapters/12-bvh/aabb.h"

bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    real from = t_min, to = t_max;
    for (int axis = 0; axis < 3; axis++) {
        const real O = along(r->O, axis), d = along(r->d, axis);
        const real low = along(box->min, axis), high = along(box->max, axis);
        if (low > high || (d == 0 && (O < low || O > high))) return false;
        if (d == 0) continue;
        const real a = (low - O) / d, b = (high - O) / d;
        from = greater(from, lesser(a, b));
        to = lesser(to, greater(a, b));
    }
    *enter = from * (1 - 4 * REAL_EPSILON);
    return *enter <= to;
}
