// Wrong: only the boxes are compared. Triangles are listed in cells that they pass by.
// Expect: looks like only the boxes are compared
// Expect: Still to come: the triangle's normal
#include "chapters/14-octree/octree.h"

bool cell_overlaps(triangle T, aabb cell) {
    const aabb box = aabb_of(T);
    return box.min.x <= cell.max.x && cell.min.x <= box.max.x && box.min.y <= cell.max.y &&
           cell.min.y <= box.max.y && box.min.z <= cell.max.z && cell.min.z <= box.max.z;
}
