// Wrong: the bounds of T, cut at the cell: not of the part in it.
// Expect: the part of T in it is smaller
// Expect: no part of T is in the cell
#include "chapters/13-kd-tree/kd_tree.h"

aabb kd_clip(triangle T, aabb cell) {
    const aabb a = aabb_of(T);
    return (aabb){{greater(a.min.x, cell.min.x), greater(a.min.y, cell.min.y),
                   greater(a.min.z, cell.min.z)},
                  {lesser(a.max.x, cell.max.x), lesser(a.max.y, cell.max.y),
                   lesser(a.max.z, cell.max.z)}};
}
