// Right: the children as boxes.
#include "chapters/13-kd-tree/kd_tree.h"

real kd_cost(aabb cell, int axis, real split, int n_below, int n_above, kd_options how) {
    aabb below = cell, above = cell;
    (&below.max.x)[axis] = (&above.min.x)[axis] = split;
    const real A = aabb_area(cell);
    real hits = (real)n_below * (aabb_area(below) / A) + (real)n_above * (aabb_area(above) / A);
    if (n_below == 0 || n_above == 0) hits *= 1 - how.bonus;
    return how.step + (real)C_HIT * hits;
}
