// Wrong: leaf size and depth alone: equal triangles are copied into all eight children, and these
// again.
// Expect: all in all children
// Expect: divides once at most
#include "chapters/14-octree/octree.h"

bool worth_dividing(octree_options how, int depth, int count, const int inside[8]) {
    (void)inside;
    return count > how.leaf_size && depth < how.depth;
}
