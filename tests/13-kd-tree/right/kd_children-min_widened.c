// Right: t is cut to the span first, and then widened: by a few roundings beyond it.
#include "chapters/13-kd-tree/kd_tree.h"

kd_order kd_children(real split, real O, real inverse, span in) {
    const real t = (split - O) * inverse;
    return (kd_order){inverse < 0,
                      {in.t0, lesser(t, in.t1) * KD_LATER},
                      {greater(t, in.t0) * KD_EARLIER, in.t1}};
}
