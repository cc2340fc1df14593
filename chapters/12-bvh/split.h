// split.h: where a node is divided, by each of the rules.
#ifndef CHAPTER_SPLIT_H
#define CHAPTER_SPLIT_H

#include "chapters/12-bvh/bvh.h"

// Orders items[0 … count - 1], whose common box is `box`, so that the first ones of them go to
// the left, and returns how many those are: 1 to count - 1; or 0, where the rule finds no
// division or one leaf of all is cheaper. count >= 2.
typedef int split_function(bvh_item *items, int count, aabb box, bvh_options how);

split_function split_by_median, split_by_midpoint, split_by_bins, split_by_sweep;

aabb items_box(const bvh_item *items, int count);
aabb items_centres(const bvh_item *items, int count); // the box of the boxes' centres
int longest_axis(aabb box);

#endif
