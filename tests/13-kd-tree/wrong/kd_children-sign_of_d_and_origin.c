// Wrong: the child that comes first by the sign of d, and "the plane is met before O, so
// only that one", although O lies on the other side.
// Expect: O's side is not below
// Expect: the whole span is above the plane
#include "chapters/13-kd-tree/kd_tree.h"

kd_order kd_children(real split, real O, real inverse, span in) {
    const real t = (split - O) * inverse;
    const span none = {1, 0};
    const int first = signbit(inverse) ? 1 : 0;
    if (t < 0 || t * KD_LATER >= in.t1) return (kd_order){first, in, none};
    if (t * KD_EARLIER <= in.t0) return (kd_order){first, none, in};
    return (kd_order){first, {in.t0, t * KD_LATER}, {t * KD_EARLIER, in.t1}};
}
