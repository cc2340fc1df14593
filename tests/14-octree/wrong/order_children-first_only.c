// Wrong: the first child and its opposite are right, the rest in between as it comes.
// Expect: no ray goes from a later child to an earlier one
#include "chapters/14-octree/octree.h"

void order_children(vec3 d, int order[8]) {
    const int first = (d.x < 0) | (d.y < 0) << 1 | (d.z < 0) << 2;
    int k = 0;
    order[k++] = first;
    for (int i = 0; i < 8; i++)
        if (i != first && i != 7 - first) order[k++] = i;
    order[k] = 7 - first;
}
