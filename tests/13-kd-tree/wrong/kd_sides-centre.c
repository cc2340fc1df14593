// Wrong: one side by the centre, as in a BVH.
// Expect: the plane cuts the box
#include "chapters/13-kd-tree/kd_tree.h"

int kd_sides(aabb box, int axis, real split) {
    return along(aabb_centre(box), axis) <= split ? KD_BELOW : KD_ABOVE;
}
