// Right: in double, rounded at the end.
#include "chapters/12-bvh/aabb.h"

bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    double from = t_min, to = t_max;
    for (int axis = 0; axis < 3; axis++) {
        const double O = along(r->O, axis), d = along(r->d, axis);
        const double low = along(box->min, axis) - O, high = along(box->max, axis) - O;
        if (low > high) return false;
        if (d == 0 && (low > 0 || high < 0)) return false;
        if (d == 0) continue;
        const double in = (d < 0 ? high : low) / d, out = (d < 0 ? low : high) / d;
        if (in > from) from = in;
        if (out < to) to = out;
    }
    *enter = (real)from * (1 - REAL_EPSILON);
    return from <= to * (1 + 4 * DBL_EPSILON);
}
