// Wrong: one off: child i is counted too.
// Expect: child i counted too
#include "chapters/14-octree/octree.h"

int child_index(unsigned mask, int i) {
    int count = 0;
    for (int k = 0; k <= i; k++) count += (int)(mask >> k & 1);
    return count;
}
