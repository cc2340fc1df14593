// Wrong: t is compared with the span before it is widened.
// Expect: before it was widened
#include "chapters/13-kd-tree/kd_tree.h"

kd_order kd_children(real split, real O, real inverse, span in) {
    const real t = (split - O) * inverse;
    const span none = {1, 0};
    const int first = inverse < 0;
    if (t < in.t0) return (kd_order){first, none, in};
    if (t > in.t1) return (kd_order){first, in, none};
    return (kd_order){
        first, {in.t0, lesser(t * KD_LATER, in.t1)}, {greater(t * KD_EARLIER, in.t0), in.t1}};
}
