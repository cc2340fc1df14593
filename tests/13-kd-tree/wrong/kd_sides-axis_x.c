// Wrong: along x, whatever the axis.
// Expect: across axis 1
#include "chapters/13-kd-tree/kd_tree.h"

// What is not below lies above: there is no third place to be lost in.
int kd_sides(aabb box, int axis, real split) {
    (void)axis;
    const real low = box.min.x, high = box.max.x;
    const bool below = low < split || high <= split, above = high > split;
    return (below ? KD_BELOW : 0) | (above ? KD_ABOVE : 0);
}
