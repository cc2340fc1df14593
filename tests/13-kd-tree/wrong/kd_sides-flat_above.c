// Wrong: what is flat and lies in the plane is above.
// Expect: in the child above: flat ones go below
#include "chapters/13-kd-tree/kd_tree.h"

int kd_sides(aabb box, int axis, real split) {
    const real low = along(box.min, axis), high = along(box.max, axis);
    return (low < split ? KD_BELOW : 0) | (high > split || low >= split ? KD_ABOVE : 0);
}
