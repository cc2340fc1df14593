// Wrong: sorted by how far the children's middles are along d: beside a large component a small
// one is rounded away.
// Expect: a sum of components forgets the small one
#include "chapters/14-octree/octree.h"

static real distance(vec3 d, int i) {
    return (i & 1 ? d.x : 0) + (i & 2 ? d.y : 0) + (i & 4 ? d.z : 0);
}

void order_children(vec3 d, int order[8]) {
    for (int i = 0; i < 8; i++) {
        int k = i;
        for (; k > 0 && distance(d, order[k - 1]) > distance(d, i); k--)
            order[k] = order[k - 1];
        order[k] = i;
    }
}
