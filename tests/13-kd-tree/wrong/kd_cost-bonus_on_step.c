// Wrong: the bonus is taken off the step as well.
// Expect: the bonus on the step too
// Expect: ok    kd_cost: by hand
#include "chapters/13-kd-tree/kd_tree.h"

real kd_cost(aabb cell, int axis, real split, int n_below, int n_above, kd_options how) {
    aabb below = cell, above = cell;
    (&below.max.x)[axis] = (&above.min.x)[axis] = split;
    const real A = aabb_area(cell);
    const real hits = ((real)n_below * aabb_area(below) + (real)n_above * aabb_area(above)) / A;
    const real cost = how.step + (real)C_HIT * hits;
    return n_below == 0 || n_above == 0 ? (1 - how.bonus) * cost : cost;
}
