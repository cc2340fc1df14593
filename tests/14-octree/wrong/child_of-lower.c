// Wrong: the bits name the lower halves.
// Expect: the other half along each axis
#include "chapters/14-octree/octree.h"

int child_of(vec3 p, vec3 middle) {
    return (p.x < middle.x) | (p.y < middle.y) << 1 | (p.z < middle.z) << 2;
}
