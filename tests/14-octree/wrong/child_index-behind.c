// Wrong: the children behind i are counted.
// Expect: the children behind i counted
#include "chapters/14-octree/octree.h"

int child_index(unsigned mask, int i) {
    int count = 0;
    for (int k = i + 1; k < 8; k++) count += (int)(mask >> k & 1);
    return count;
}
