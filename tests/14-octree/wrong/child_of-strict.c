// Wrong: a point on the dividing plane is put into the lower half.
// Expect: a point on the plane put into the lower half
#include "chapters/14-octree/octree.h"

int child_of(vec3 p, vec3 middle) {
    return (p.x > middle.x) | (p.y > middle.y) << 1 | (p.z > middle.z) << 2;
}
