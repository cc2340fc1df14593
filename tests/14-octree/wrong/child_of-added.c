// Wrong: 1, 2 and 3.
// Expect: 1, 2 and 3 in place of 1, 2 and 4
#include "chapters/14-octree/octree.h"

int child_of(vec3 p, vec3 middle) {
    return (p.x >= middle.x) + 2 * (p.y >= middle.y) + 3 * (p.z >= middle.z);
}
