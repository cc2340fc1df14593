// Wrong: | in place of ^: some children come twice.
// Expect: stands there twice
// Expect: each once: which place does each child get?
#include "chapters/14-octree/octree.h"

void order_children(vec3 d, int order[8]) {
    const int mirrored = (d.x < 0) | (d.y < 0) << 1 | (d.z < 0) << 2;
    for (int i = 0; i < 8; i++) order[i] = i | mirrored;
}
