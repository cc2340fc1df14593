// Wrong: the child below always comes first.
// Expect: the order of another ray
#include "chapters/13-kd-tree/kd_tree.h"

kd_order kd_children(real split, real O, real inverse, span in) {
    const real t = (split - O) * inverse;
    const span near = {in.t0, lesser(t * KD_LATER, in.t1)};
    const span far = {greater(t * KD_EARLIER, in.t0), in.t1};
    return signbit(inverse) ? (kd_order){0, far, near} : (kd_order){0, near, far};
}
