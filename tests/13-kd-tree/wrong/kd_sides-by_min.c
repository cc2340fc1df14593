// Wrong: one side by where the box begins.
// Expect: the plane cuts the box
#include "chapters/13-kd-tree/kd_tree.h"

// What is not below lies above: there is no third place to be lost in.
int kd_sides(aabb box, int axis, real split) {
    const real low = along(box.min, axis), high = along(box.max, axis);
    const bool below = low < split || high <= split, above = low >= split;
    return (below ? KD_BELOW : 0) | (above ? KD_ABOVE : 0);
}
