// Wrong: all triangles of each child are tested.
// Expect: all that is inside, not a quarter of it
#include "chapters/14-octree/octree.h"

bool worth_dividing(octree_options how, int depth, int count, const int inside[8]) {
    if (count <= how.leaf_size || depth >= how.depth) return false;
    double cost = 0;
    for (int i = 0; i < 8; i++)
        if (inside[i]) cost += C_STEP + C_HIT * inside[i];
    return cost < C_HIT * count;
}
