#include "chapters/14-octree/octree.h"

// For a direction with all components positive 0 to 7 is an order: no bit ever goes back. A
// negative component mirrors its axis. Where it is ±0 no ray crosses, and either will do.
void order_children(vec3 d, int order[8]) {
    const int mirrored = (d.x < 0) | (d.y < 0) << 1 | (d.z < 0) << 2;
    for (int i = 0; i < 8; i++) order[i] = i ^ mirrored;
}
