// Wrong: what touches the plane goes to both sides.
// Expect: in both: a reference more than needed
#include "chapters/13-kd-tree/kd_tree.h"

int kd_sides(aabb box, int axis, real split) {
    return (along(box.min, axis) <= split ? KD_BELOW : 0) |
           (along(box.max, axis) >= split ? KD_ABOVE : 0);
}
