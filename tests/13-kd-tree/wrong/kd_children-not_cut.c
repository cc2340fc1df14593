// Wrong: the parts are not cut at the cell: the walk goes on where the ray has left it.
// Expect: no part reaches beyond the cell's end
// Expect: A part ends with the cell
#include "chapters/13-kd-tree/kd_tree.h"

kd_order kd_children(real split, real O, real inverse, span in) {
    const real t = (split - O) * inverse;
    if (t != t) return (kd_order){0, in, in};
    return (kd_order){inverse < 0, {in.t0, t * KD_LATER}, {t * KD_EARLIER, in.t1}};
}
