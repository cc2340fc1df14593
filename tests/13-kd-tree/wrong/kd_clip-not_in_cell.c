// Wrong: the result is not cut at the cell.
// Expect: the bounds stay in the cell
// Expect: the cell's own sides
#include "chapters/13-kd-tree/kd_tree.h"

enum { MOST = 16 }; // a triangle, a corner more for each of six planes, and room for rounding

typedef struct {
    double x[3];
} point;

typedef struct {
    point p[MOST];
    int count;
} polygon;

static point point_of(vec3 p) {
    return (point){{p.x, p.y, p.z}};
}

// Where the edge from a to b meets the plane; a and b are on different sides of it.
static point crossing(point a, point b, int axis, double split) {
    const double s = (split - a.x[axis]) / (b.x[axis] - a.x[axis]);
    point p;
    for (int i = 0; i < 3; i++) p.x[i] = a.x[i] + s * (b.x[i] - a.x[i]);
    p.x[axis] = split;
    return p;
}

// What of the polygon lies below the plane (side = 1) or above it (-1).
static polygon cut(const polygon *from, int axis, double split, int side) {
    polygon to = {.count = 0};
    for (int i = 0; i < from->count; i++) {
        const point a = from->p[i], b = from->p[(i + 1) % from->count];
        const bool a_in = side * (split - a.x[axis]) >= 0,
                   b_in = side * (split - b.x[axis]) >= 0;
        if (a_in && to.count < MOST) to.p[to.count++] = a;
        if (a_in != b_in && to.count < MOST) to.p[to.count++] = crossing(a, b, axis, split);
    }
    return to;
}

// The next number of `real` at or below x.
static real rounded_down(double x) {
    const real y = (real)x;
    return (double)y > x ? nextafter(y, (real)-INFINITY) : y;
}

static void hold(real *min, real *max, double low, double high) {
    *min = greater(*min, rounded_down(low));
    *max = lesser(*max, -rounded_down(-high));
}

// The crossings are rounded: each by less than `margin`. With the cell and the result larger by
// that much nothing is lost. Planes beyond T cut nothing off.
aabb kd_clip(triangle T, aabb cell) {
    const aabb whole = aabb_of(T);
    const vec3 far = add(absolute(whole.min), absolute(whole.max));
    const double margin = 16 * DBL_EPSILON * (double)greater(far.x, greater(far.y, far.z));
    polygon part = {{point_of(T.p1), point_of(T.p2), point_of(T.p3)}, 3};
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int axis = 0; axis < 3; axis++) {
        const real from = along(cell.min, axis), to = along(cell.max, axis);
        if (along(whole.min, axis) < from) part = cut(&part, axis, (double)from - margin, -1);
        if (along(whole.max, axis) > to) part = cut(&part, axis, (double)to + margin, 1);
    }
    if (part.count == 0) return aabb_empty;
    for (int i = 0; i < part.count; i++)
        for (int axis = 0; axis < 3; axis++) {
            const double x = part.p[i].x[axis];
            low[axis] = x - margin < low[axis] ? x - margin : low[axis];
            high[axis] = x + margin > high[axis] ? x + margin : high[axis];
        }
    aabb box = {{whole.min.x, whole.min.y, greater(cell.min.z, whole.min.z)},
                {lesser(cell.max.x, whole.max.x), lesser(cell.max.y, whole.max.y),
                 lesser(cell.max.z, whole.max.z)}};
    hold(&box.min.x, &box.max.x, low[0], high[0]);
    hold(&box.min.y, &box.max.y, low[1], high[1]);
    hold(&box.min.z, &box.max.z, low[2], high[2]);
    return box;
}
