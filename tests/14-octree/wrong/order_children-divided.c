// Wrong: the sign as d / |d|, which is NaN for 0 and -0.
// Expect: each child once
// Expect: No division by a component
#include "chapters/14-octree/octree.h"

static int bit(real a) {
    const real sign = a / fabs(a); // 1, -1, or NaN
    return sign == 1 ? 0 : sign == -1 ? 1 : 9;
}

void order_children(vec3 d, int order[8]) {
    const int mirrored = bit(d.x) ^ bit(d.y) << 1 ^ bit(d.z) << 2;
    for (int i = 0; i < 8; i++) order[i] = i ^ mirrored;
}
