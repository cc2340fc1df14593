// split.h: where a node is divided, by each of the rules.
#ifndef CHAPTER_SPLIT_H
#define CHAPTER_SPLIT_H

#include "chapters/12-bvh/bvh.h"

// The boxes that hold some items, and that hold the centres of their boxes.
typedef struct {
    aabb box, centres;
} extent;

extent items_extent(const bvh_item *items, int count);
int longest_axis(aabb box);

// Orders items[0 … count - 1], whose extent is `in`, so that the first ones of them go to
// the left, and returns how many those are: 1 to count - 1; or 0, where the rule finds no
// division or one leaf of all is cheaper. count >= 2.
typedef int split_function(bvh_item *items, int count, extent in, bvh_options how);

split_function split_by_median, split_by_midpoint, split_by_bins, split_by_sweep;

#endif
