// Wrong: signbit gives any number that is not 0, and first is 0 or 1.
// Expect: signbit gives 0 or any other number
#include "chapters/13-kd-tree/kd_tree.h"

kd_order kd_children(real split, real O, real inverse, span in) {
    const real t = (split - O) * inverse;
    const span near = {in.t0, lesser(t * KD_LATER, in.t1)};
    const span far = {greater(t * KD_EARLIER, in.t0), in.t1};
    return (kd_order){128 * (signbit(inverse) != 0), near, far}; // what some compilers give
}
