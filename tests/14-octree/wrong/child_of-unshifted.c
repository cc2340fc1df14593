// Wrong: no shift.
// Expect: all three in bit 0
#include "chapters/14-octree/octree.h"

int child_of(vec3 p, vec3 middle) {
    return (p.x >= middle.x) | (p.y >= middle.y) | (p.z >= middle.z);
}
