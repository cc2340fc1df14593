// Wrong: counted from 8 downwards.
// Expect: 8 is no child, child 0 stands there never
#include "chapters/14-octree/octree.h"

void order_children(vec3 d, int order[8]) {
    const int mirrored = (d.x < 0) | (d.y < 0) << 1 | (d.z < 0) << 2;
    for (int i = 0; i < 8; i++) order[i] = 8 - ((7 - i) ^ mirrored);
}
