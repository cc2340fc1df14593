// Right: what of the triangle is in the cell, a little larger, is cut out, side by side.
#include "chapters/14-octree/octree.h"
#include "common/wide3.h"

typedef struct {
    wide3 p[9];
    int count;
} polygon;

static double part(wide3 p, int axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

// What lies on the side `sign` of the plane.
static polygon cut(polygon a, int axis, int sign, double side) {
    polygon b = {.count = 0};
    for (int i = 0; i < a.count; i++) {
        const wide3 p = a.p[i], q = a.p[(i + 1) % a.count];
        const double s = sign * (part(p, axis) - side), t = sign * (part(q, axis) - side);
        if (s >= 0) b.p[b.count++] = p;
        if ((s < 0 && t > 0) || (s > 0 && t < 0))
            b.p[b.count++] = wide_along(p, s / (s - t), wide_along(q, -1, p));
    }
    return b;
}

bool cell_overlaps(triangle T, aabb cell) {
    polygon a = {{widen(T.p1), widen(T.p2), widen(T.p3)}, 3};
    const aabb all = aabb_join(aabb_of(T), cell);
    for (int axis = 0; axis < 3; axis++) {
        const double low = (double)along(cell.min, axis), high = (double)along(cell.max, axis);
        const double most =
            fabs((double)along(all.min, axis)) + fabs((double)along(all.max, axis));
        const double room = 8 * DBL_EPSILON * (most + (high - low));
        a = cut(a, axis, 1, low - room);
        a = cut(a, axis, -1, high + room);
    }
    return a.count > 0;
}
