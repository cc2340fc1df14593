// Right: by the number of planes that lie between a child and the first one.
#include "chapters/14-octree/octree.h"

void order_children(vec3 d, int order[8]) {
    const int first = (signbit(d.x) != 0) | (signbit(d.y) != 0) << 1 | (signbit(d.z) != 0) << 2;
    int k = 0;
    for (int crossings = 0; crossings <= 3; crossings++) {
        for (int i = 0; i < 8; i++) {
            const int between = i ^ first;
            if ((between & 1) + (between >> 1 & 1) + (between >> 2) == crossings)
                order[k++] = i;
        }
    }
}
