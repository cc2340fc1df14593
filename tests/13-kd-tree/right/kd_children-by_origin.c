// Right: the first child is the one where O lies, and the cases are told apart one by one.
#include "chapters/13-kd-tree/kd_tree.h"

kd_order kd_children(real split, real O, real inverse, span in) {
    const span none = {1, 0};
    if (O == split && isinf(inverse)) return (kd_order){0, in, in};
    if (O == split) return (kd_order){inverse > 0 ? 1 : 0, in, {in.t0, 0}};
    const int first = O < split ? 0 : 1;
    const real t = (split - O) * inverse;
    if (t < 0 || isinf(t) || t * KD_EARLIER > in.t1) return (kd_order){first, in, none};
    if (t * KD_LATER < in.t0) return (kd_order){first, none, in};
    return (kd_order){
        first, {in.t0, lesser(t * KD_LATER, in.t1)}, {greater(t * KD_EARLIER, in.t0), in.t1}};
}
