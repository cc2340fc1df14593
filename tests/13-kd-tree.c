// Tests of 13-kd-tree: one plane, the bounds of a part, the walk, whole trees.
#include "tests/13-kd-tree-parts.h"
#include "tests/13-kd-tree-walk.h"

#define WAYS \
    "A cell is closed, and t counts from O: in which of the two is the ray before the plane?"
#define WALK \
    "A leaf's triangle may be hit behind the cell's end. What may still lie before that hit?"

#define FIRST "Does an exercise above fail? That one first. "

int main(void) {
    static const test tests[] = {
        {"kd_sides: by hand", sides_by_hand,
         "Take the cases one by one: low and high below, at and above the plane."},
        {"kd_sides: generic boxes", sides_generic, "Both comparisons are with the plane."},
        {"kd_children: by hand", children_by_hand, WAYS},
        {"kd_children: one child only", children_one,
         "Where the plane is met before the cell, behind it, or behind O, one child holds "
         "all."},
        {"kd_children: along the plane, d = ±0", children_along,
         "1 / d is infinite: beside the plane its sign decides; in the plane 0 times infinity "
         "is NaN: "
         "which comparison lets the span stand?"},
        {"kd_children: from the plane", children_on_plane,
         "t = 0 at the plane: the sign of d says where the ray goes."},
        {"kd_children: generic rays, thin cells", children_generic,
         "Below the plane until t, above from t on, or the other way round."},
        {"kd_cost: by hand", cost_by_hand,
         "Term by term: how.step; each count times its child's area over the cell's."},
        {"kd_cost: one child is empty", cost_empty,
         "The hits' part times 1 - how.bonus, whichever child is empty; the step as it is."},
        {"kd_cost: generic cells", cost_generic,
         "By hand it is right: what differs here? Another axis, larger counts, sizes, "
         "options?"},
        {"kd_clip: by hand", clip_by_hand,
         "Cut the polygon at each of the six planes; where an edge crosses one a corner is "
         "new."},
        {"kd_clip: nothing in the cell", clip_nothing,
         "When no corner of the polygon is left, nothing is in the cell: aabb_empty."},
        {"kd_clip: touching and flat", clip_touching,
         "The cell is closed: a corner in the plane stays."},
        {"kd_clip: generic, against 33 digits", clip_generic,
         "A crossing is rounded. Which way must the bounds go so that nothing is lost?"},
        {"kd_nearest: by hand", nearest_by_hand, WALK},
        {"kd_nearest: t_min and t_max", nearest_interval,
         "t_min < t < t_max; index only with a hit."},
        {"kd_nearest: a tree without triangles", nearest_nothing,
         "A miss, before any node is asked."},
        {"kd_nearest: steps and tests", nearest_effort,
         "One step for the root's box and for each plane asked, one test for each triangle."},
        {"kd_nearest: ties", nearest_ties,
         "A cell that begins just where the hit lies may hold the same t and a smaller index."},
        {"kd_nearest: ends at the first hit", nearest_ends,
         "What waits and begins behind the nearest hit need not be asked."},
        {"kd_nearest: hard scenes, as brute force", nearest_scenes, WALK},
        {"kd_nearest: shapes, as brute force", nearest_shapes, WALK},
        {"kd_nearest: 150,000 rays, as brute force", nearest_many, WALK},
        {"kd_nearest: no leak", nearest_leaks,
         FIRST
         "A far cell that the ray is in for less than a rounding must be visited, too; and "
         "one for which t0 = t1."},
        {"kd_build: promises", build_promises, FIRST "See kd_flaw."},
        {"kd_build: options", build_options, FIRST "A tree of any options finds the same."},
        {"kd_build: twice the same", build_twice,
         FIRST "No order of memory or time may enter."},
        {"kd_build: pays", build_pays, FIRST "Divisions by kd_cost, sides by kd_sides."},
        {"kd_flaw: sees", build_flaws, FIRST "Each promise is looked at."},
        {"kd_any: as brute force", any_scenes, FIRST "Every cell that the ray is in."},
        {"searcher: all agree", searchers_agree, FIRST "One contract for all."},
        {"kd_finder: as the mesh's finder", as_finder, FIRST "kd_nearest and kd_any."},
    };
    return run_tests("13-kd-tree", tests, COUNT(tests));
}
