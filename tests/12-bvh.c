// Tests of 12-bvh: the exercises, the tree, the shapes and the reader of OBJ files.
#include "tests/12-bvh-build.h"
#include "tests/12-bvh-obj.h"
#include "tests/12-bvh-shapes.h"

int main(void) {
    static const test tests[] = {
        {"aabb_hit: by hand", slabs_worked_out,
         "Three intervals of t, one an axis: what do they have in common, with [t_min, t_max] "
         "too? r->near and r->far say which side comes first."},
        {"aabb_hit: any ray and any box", slabs_generic,
         "The latest entry against the earliest exit. Where d is negative, max comes first."},
        {"aabb_hit: d = ±0, in a face too", slabs_zero,
         "In a face 0 · infinity is NaN: it must set no limit, so which operand of > or < may "
         "be "
         "NaN? Outside, an infinite t decides."},
        {"aabb_hit: flat boxes", slabs_flat,
         "Entry and exit are equal in a flat box: that is a hit."},
        {"aabb_hit: edges and corners", slabs_edges,
         "Entry and exit are nearly equal, and both are rounded: make the interval longer by "
         "what "
         "rounding may have taken, and no longer."},
        {"aabb_hit: far, large and small", slabs_sizes,
         "The bound on the roundings is relative; and no rounding may be magnified: subtract "
         "first."},
        {"aabb_hit: the empty box", slabs_empty,
         "min = infinity, max = -infinity: enter > exit."},
        {"split_median: up to 40 items", median_small,
         "The first count / 2 on one side, rounded down; the boxes' centres decide, along "
         "`axis`."},
        {"split_median: 200,000 items in bad orders", median_large,
         "How many steps does it take when all centres are equal, or sorted already?"},
        {"split_at: up to 40 items", split_at_small,
         "Below: <. An item that is swapped in from the end has not been asked yet."},
        {"split_at: 200,000 items", split_at_large, "One pass is enough."},
        {"sah_cost: by hand", cost_by_hand,
         "C_step + C_hit (n_l A_l + n_r A_r) / A, with the surface area as in aabb_area."},
        {"sah_cost: any boxes", cost_generic,
         "Counts times areas; only their ratio to A counts."},
        {"bvh_nearest: by hand", nearest_by_hand,
         "Both children may be met: which one first, and when is the other still needed?"},
        {"bvh_nearest: what is missed", nearest_misses,
         "A miss is t = NO_HIT, index untouched."},
        {"bvh_nearest: a few triangles, many rays", nearest_many,
         "A hit in the near child does not end the search: boxes overlap. What waits on the "
         "stack is dropped only when it begins beyond the limit."},
        {"bvh_nearest: equally near", nearest_ties,
         "Of equally near triangles the smallest index: a box that begins just at the hit must "
         "be looked into. leaf_nearest and its limit see to it."},
        {"bvh_nearest: scenes that are hard on a tree", nearest_scenes,
         "No triangle, one, all alike, flat, NaN: is there a root? And is the far child looked "
         "into?"},
        {"bvh_nearest: all shapes", nearest_shapes,
         "Every child whose box is met must be looked into, unless it begins beyond the "
         "limit."},
        {"bvh_nearest: the deepest tree", nearest_deepest,
         "How many nodes may wait? One for each level: BVH_DEPTH."},
        {"bvh_nearest: effort", nearest_effort,
         "One step for each box asked, the tests by leaf_nearest; a box that is missed is not "
         "looked into."},
        {"bvh_nearest: effort, in order", nearest_order,
         "The nearer child first. found.limit is t_max for every box that is asked; and what "
         "waits is dropped when its turn comes and it begins beyond the limit."},
        {"bvh_nearest: no leak", nearest_sealed,
         "A ray at an edge passes boxes at their edges: are all looked into?"},
        {"bvh_any: by hand", any_by_hand,
         "Any hit between t_min and t_max will do, none else."},
        {"bvh_any: a few triangles, many rays", any_many,
         "true at the first hit; false only when every box that is met was looked into."},
        {"bvh_any: scenes that are hard on a tree", any_scenes,
         "t_max ends the ray: at the boxes and in the leaves. Is there a root?"},
        {"bvh_any: all shapes", any_shapes, "Are both children looked into, if need be?"},
        {"bvh_any: the deepest tree", any_deepest,
         "How many nodes may wait? One for each level: BVH_DEPTH."},
        {"bvh_any: effort", any_effort,
         "One step for each box asked, the tests by leaf_any; the first hit ends it."},
        {"bvh_refit: moved triangles", refit_scenes,
         "Copies of the triangles first, then every node's box: children before their "
         "parents."},
        {"bvh_refit: nothing moved", refit_nothing, "Nothing has moved: nothing changes."},
        {"bvh_build: scenes that are hard on a tree", builds_of_scenes,
         "Given code: did it change?"},
        {"bvh_build: all shapes", builds_of_shapes, "Given code: did it change?"},
        {"bvh_measure: what the rules are worth", build_figures, "Given code: did it change?"},
        {"bvh_measure: by hand", figures_by_hand, "Given code: did it change?"},
        {"bvh_flaw: finds every damage", flaw_finds, "Given code: did it change?"},
        {"bvh_flaw: too deep", flaw_depth, "Given code: did it change?"},
        {"bvh_flaw: no longer finite", flaw_not_finite, "Given code: did it change?"},
        {"bvh_finder: the finder of a mesh", finder_of_mesh, "Given code: did it change?"},
        SHAPE_TESTS,
        OBJ_TESTS,
    };
    return run_tests("12-bvh", tests, COUNT(tests));
}
