// Right: the cases, one after the other.
#include "chapters/13-kd-tree/kd_tree.h"

int kd_sides(aabb box, int axis, real split) {
    if (along(box.max, axis) <= split) return KD_BELOW;
    if (along(box.min, axis) >= split) return KD_ABOVE;
    return KD_BELOW | KD_ABOVE;
}
