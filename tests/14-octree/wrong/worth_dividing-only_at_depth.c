// Wrong: only at how.depth itself it ends.
// Expect: depth 13
// Expect: nor deeper
#include "chapters/14-octree/octree.h"

bool worth_dividing(octree_options how, int depth, int count, const int inside[8]) {
    if (count <= how.leaf_size || depth == how.depth) return false;
    double cost = 0;
    for (int i = 0; i < 8; i++)
        if (inside[i]) cost += C_STEP + C_HIT * inside[i] / 4.0;
    return cost < C_HIT * count;
}
