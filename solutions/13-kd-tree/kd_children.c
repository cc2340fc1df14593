#include "chapters/13-kd-tree/kd_tree.h"

// Along d > 0 what is below the plane always comes first: wherever O lies, the ray is there
// until t and above from t on. A ray along the plane, d = ±0, passes it at t = ±infinity,
// which puts it on O's side. In the plane t is 0 · infinity, NaN: it loses both comparisons,
// and the whole span stays on both sides.
kd_order kd_children(real split, real O, real inverse, span in) {
    const real t = (split - O) * inverse;
    const span near = {in.t0, lesser(t * KD_LATER, in.t1)};
    const span far = {greater(t * KD_EARLIER, in.t0), in.t1};
    return (kd_order){inverse < 0, near, far};
}
