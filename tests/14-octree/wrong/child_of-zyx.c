// Wrong: x is bit 2 and z is bit 0.
// Expect: bit 0 taken for z and bit 2 for x
#include "chapters/14-octree/octree.h"

int child_of(vec3 p, vec3 middle) {
    return (p.x >= middle.x) << 2 | (p.y >= middle.y) << 1 | (p.z >= middle.z);
}
