// Wrong: what is flat and lies in the plane is neither below nor above.
// Expect: the box is flat and lies in the plane
// Expect: in no child: the primitive is lost
#include "chapters/13-kd-tree/kd_tree.h"

int kd_sides(aabb box, int axis, real split) {
    return (along(box.min, axis) < split ? KD_BELOW : 0) |
           (along(box.max, axis) > split ? KD_ABOVE : 0);
}
