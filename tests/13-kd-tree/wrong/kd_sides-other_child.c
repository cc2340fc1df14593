// Wrong: below and above exchanged.
// Expect: in the other child
// Expect: Below is where the coordinate is smaller
#include "chapters/13-kd-tree/kd_tree.h"

int kd_sides(aabb box, int axis, real split) {
    const real low = along(box.min, axis), high = along(box.max, axis);
    const bool below = low < split || high <= split, above = high > split;
    return (below ? KD_ABOVE : 0) | (above ? KD_BELOW : 0);
}
