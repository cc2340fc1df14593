// Wrong: shifted by 1, 2 and 3.
// Expect: one bit too far to the left
#include "chapters/14-octree/octree.h"

int child_of(vec3 p, vec3 middle) {
    return (p.x >= middle.x) << 1 | (p.y >= middle.y) << 2 | (p.z >= middle.z) << 3;
}
