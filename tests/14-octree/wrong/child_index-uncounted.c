// Wrong: the bits below i, not how many they are.
// Expect: the bits below i themselves
#include "chapters/14-octree/octree.h"

int child_index(unsigned mask, int i) {
    return (int)(mask & ((1u << i) - 1));
}
