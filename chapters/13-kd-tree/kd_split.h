// kd_split.h: the plane that divides a cell best.
#ifndef CHAPTER_KD_SPLIT_H
#define CHAPTER_KD_SPLIT_H

#include "chapters/13-kd-tree/kd_tree.h"

typedef struct {
    real cost;
    int axis; // -1: none
    real split;
} kd_plane;

// The cheapest plane strictly inside the cell, by kd_cost, that is cheaper than a leaf of all
// `count` items; axis -1 when none is. Candidates are the items' bounds: all of them up to
// KD_FEW items, above that the outermost and KD_BINS - 1 planes at equal distances.
kd_plane kd_best_plane(const bvh_item *items, int count, aabb cell, kd_options how);
enum { KD_FEW = 256, KD_BINS = 64 };

#endif
