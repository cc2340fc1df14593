// Wrong: the areas are kept in int: the division is one of whole numbers.
// Expect: whole numbers divided
// Expect: It fails by hand, too: that one first
#include "chapters/13-kd-tree/kd_tree.h"

real kd_cost(aabb cell, int axis, real split, int n_below, int n_above, kd_options how) {
    aabb below = cell, above = cell;
    (&below.max.x)[axis] = (&above.min.x)[axis] = split;
    const int A = (int)aabb_area(cell), A_b = (int)aabb_area(below),
              A_a = (int)aabb_area(above);
    const real hits = (real)(A ? (n_below * A_b + n_above * A_a) / A : 0);
    return how.step + (n_below == 0 || n_above == 0 ? 1 - how.bonus : 1) * hits;
}
