// Wrong: the signs of d are ignored.
// Expect: this is 0 to 7, whatever the signs of d
#include "chapters/14-octree/octree.h"

void order_children(vec3 d, int order[8]) {
    (void)d;
    for (int i = 0; i < 8; i++) order[i] = i;
}
