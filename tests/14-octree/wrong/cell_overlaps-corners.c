// Wrong: only where a corner of the triangle is in the cell.
// Expect: no corner lies in the cell
#include "chapters/14-octree/octree.h"

static bool holds(aabb cell, vec3 p) {
    return cell.min.x <= p.x && p.x <= cell.max.x && cell.min.y <= p.y && p.y <= cell.max.y &&
           cell.min.z <= p.z && p.z <= cell.max.z;
}

bool cell_overlaps(triangle T, aabb cell) {
    return holds(cell, T.p1) || holds(cell, T.p2) || holds(cell, T.p3);
}
