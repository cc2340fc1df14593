// Wrong: bit 0 by the sign of d.z.
// Expect: along x the order goes by the sign of d.z
#include "chapters/14-octree/octree.h"

void order_children(vec3 d, int order[8]) {
    const int mirrored = (d.z < 0) | (d.y < 0) << 1 | (d.x < 0) << 2;
    for (int i = 0; i < 8; i++) order[i] = i ^ mirrored;
}
