// Wrong: no limit of depth: a heap of equal triangles is divided for ever.
// Expect: Else the division never ends
#include "chapters/14-octree/octree.h"

bool worth_dividing(octree_options how, int depth, int count, const int inside[8]) {
    (void)depth, (void)inside;
    return count > how.leaf_size;
}
