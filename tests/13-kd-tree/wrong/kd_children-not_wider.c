// Wrong: the spans end at the rounded t.
// Expect: is not cut short
// Expect: KD_LATER, KD_EARLIER
#include "chapters/13-kd-tree/kd_tree.h"

kd_order kd_children(real split, real O, real inverse, span in) {
    const real t = (split - O) * inverse;
    const span near = {in.t0, lesser(t, in.t1)}, far = {greater(t, in.t0), in.t1};
    return (kd_order){signbit(inverse) ? 1 : 0, near, far};
}
