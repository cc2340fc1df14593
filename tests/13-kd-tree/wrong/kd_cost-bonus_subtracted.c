// Wrong: the bonus is subtracted, not multiplied.
// Expect: the bonus was subtracted, not multiplied
#include "chapters/13-kd-tree/kd_tree.h"

// With a and b the sides of a child that the plane leaves whole, and c the divided one.
static real area(real a, real b, real c) {
    return 2 * (a * b + (a + b) * c);
}

real kd_cost(aabb cell, int axis, real split, int n_below, int n_above, kd_options how) {
    const vec3 e = sub(cell.max, cell.min);
    const real a = along(e, (axis + 1) % 3), b = along(e, (axis + 2) % 3);
    const real A_b = area(a, b, split - along(cell.min, axis));
    const real A_a = area(a, b, along(cell.max, axis) - split);
    const real hits = (real)C_HIT * ((real)n_below * A_b + (real)n_above * A_a);
    const real bonus = n_below == 0 || n_above == 0 ? how.bonus : 0;
    return how.step + hits / aabb_area(cell) - bonus;
}
