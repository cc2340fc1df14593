// Right: in whole quarters.
#include "chapters/14-octree/octree.h"

bool worth_dividing(octree_options how, int depth, int count, const int inside[8]) {
    long quarters = 0;
    for (int i = 0; i < 8; i++)
        if (inside[i]) quarters += 4 * C_STEP + (long)C_HIT * inside[i];
    return count > how.leaf_size && depth < how.depth && quarters < 4L * C_HIT * count;
}
