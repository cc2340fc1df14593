// Wrong: one corner beyond the reach is taken for apart.
// Expect: looks like one corner beyond
// Expect: all three corners lie beyond the same end
#include "chapters/14-octree/octree.h"
#include "common/wide3.h"

static bool parts(triangle T, aabb cell, wide3 a) {
    const wide3 low = widen(cell.min), side = wide_sub(cell.max, cell.min);
    const wide3 c = wide_along(low, 0.5, side), h = wide_along((wide3){0, 0, 0}, 0.5, side);
    const double p = wide_dot(a, wide_along(widen(T.p1), -1, c)),
                 q = wide_dot(a, wide_along(widen(T.p2), -1, c)),
                 s = wide_dot(a, wide_along(widen(T.p3), -1, c));
    const double r = fabs(a.x) * h.x + fabs(a.y) * h.y + fabs(a.z) * h.z;
    return p > r || q > r || s > r || p < -r || q < -r || s < -r;
}

bool cell_overlaps(triangle T, aabb cell) {
    const wide3 e[3] = {wide_sub(T.p2, T.p1), wide_sub(T.p3, T.p2), wide_sub(T.p1, T.p3)};
    const aabb box = aabb_of(T);
    if (box.min.x > cell.max.x || cell.min.x > box.max.x || box.min.y > cell.max.y ||
        cell.min.y > box.max.y || box.min.z > cell.max.z || cell.min.z > box.max.z)
        return false;
    if (parts(T, cell, wide_cross(e[0], e[1]))) return false;
    for (int i = 0; i < 3; i++)
        if (parts(T, cell, (wide3){0, -e[i].z, e[i].y}) ||
            parts(T, cell, (wide3){e[i].z, 0, -e[i].x}) ||
            parts(T, cell, (wide3){-e[i].y, e[i].x, 0}))
            return false;
    return true;
}
