// Wrong: mask >> i drops the bits that count.
// Expect: child i and those behind it counted
#include "chapters/14-octree/octree.h"

int child_index(unsigned mask, int i) {
    unsigned x = mask >> i;
    int count = 0;
    for (; x; x &= x - 1) count++;
    return count;
}
