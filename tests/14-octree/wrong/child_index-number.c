// Wrong: mask & i.
// Expect: the bits of mask & i
#include "chapters/14-octree/octree.h"

int child_index(unsigned mask, int i) {
    unsigned x = mask & (unsigned)i;
    int count = 0;
    for (; x; x &= x - 1) count++;
    return count;
}
