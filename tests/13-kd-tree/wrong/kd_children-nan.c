// Wrong: the comparisons the other way round: in the plane t is NaN, and NaN wins.
// Expect: a ray in the plane is in both children all the way
// Expect: 0 times infinity is NaN
#include "chapters/13-kd-tree/kd_tree.h"

kd_order kd_children(real split, real O, real inverse, span in) {
    const real t = (split - O) * inverse;
    const span near = {in.t0, in.t1 < t * KD_LATER ? in.t1 : t * KD_LATER};
    const span far = {in.t0 > t * KD_EARLIER ? in.t0 : t * KD_EARLIER, in.t1};
    return (kd_order){signbit(inverse) ? 1 : 0, near, far};
}
