// Wrong: for d < 0 the child above comes first, with the part behind the plane.
// Expect: looks like t: the part behind the plane. near is the one before it
// Expect: whatever the sign of d
#include "chapters/13-kd-tree/kd_tree.h"

kd_order kd_children(real split, real O, real inverse, span in) {
    const real t = (split - O) * inverse;
    const span near = {in.t0, lesser(t * KD_LATER, in.t1)};
    const span far = {greater(t * KD_EARLIER, in.t0), in.t1};
    return inverse < 0 ? (kd_order){1, far, near} : (kd_order){0, near, far};
}
