// Wrong: the empty children are counted.
// Expect: the children that are not stored counted
#include "chapters/14-octree/octree.h"

int child_index(unsigned mask, int i) {
    int count = 0;
    for (int k = 0; k < i; k++) count += !(mask >> k & 1);
    return count;
}
