// Right: from a table of the counts of four bits.
#include "chapters/14-octree/octree.h"

int child_index(unsigned mask, int i) {
    static const int bits[16] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
    const unsigned below = mask & ~(~0u << i);
    return bits[below & 15] + bits[below >> 4];
}
