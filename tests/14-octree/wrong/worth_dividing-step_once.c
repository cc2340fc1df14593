// Wrong: one step for all children together.
// Expect: looks like one step for all children together
#include "chapters/14-octree/octree.h"

bool worth_dividing(octree_options how, int depth, int count, const int inside[8]) {
    if (count <= how.leaf_size || depth >= how.depth) return false;
    double cost = C_STEP;
    for (int i = 0; i < 8; i++) cost += C_HIT * inside[i] / 4.0;
    return cost < C_HIT * count;
}
