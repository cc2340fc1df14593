// Wrong: signbit(x) taken for 1.
// Expect: signbit(x) != 0
#include "chapters/14-octree/octree.h"

// What signbit gives may be any number but 0.
static int sign_of(real a) {
    return signbit(a) ? 128 : 0;
}

void order_children(vec3 d, int order[8]) {
    const int mirrored = sign_of(d.x) | sign_of(d.y) << 1 | sign_of(d.z) << 2;
    for (int i = 0; i < 8; i++) order[i] = i ^ mirrored;
}
