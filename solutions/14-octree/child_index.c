#include "chapters/14-octree/octree.h"

// Each round clears the lowest bit that is set (Wegner 1960).
int child_index(unsigned mask, int i) {
    unsigned below = mask & ((1u << i) - 1);
    int count = 0;
    for (; below; below &= below - 1) count++;
    return count;
}
