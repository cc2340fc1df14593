// Wrong: NaN makes every comparison false, and the ray a miss.
// Expect: In a face 0 · infinity is NaN
#include "chapters/12-bvh/aabb.h"

bool aabb_hit(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    const real *side = &box->min.x;
    const real O[] = {r->O.x, r->O.y, r->O.z};
    const real inverse[] = {r->inverse.x, r->inverse.y, r->inverse.z};
    real from = t_min, to = t_max;
    for (int axis = 0; axis < 3; axis++) {
        const real in = (side[r->near[axis]] - O[axis]) * inverse[axis];
        const real out =
            (side[r->far[axis]] - O[axis]) * inverse[axis] * (1 + 8 * REAL_EPSILON);
        if (!(in <= to && out >= from)) return false;
        from = greater(in, from);
        to = lesser(out, to);
    }
    *enter = from * (1 - 8 * REAL_EPSILON);
    return from <= to * (1 + 8 * REAL_EPSILON);
}
