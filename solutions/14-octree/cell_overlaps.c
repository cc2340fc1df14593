#include "chapters/14-octree/octree.h"
#include "common/wide3.h"

// A triangle as seen from the middle of a cell.
typedef struct {
    wide3 p[3];
    wide3 half; // the cell reaches from -half to half, made larger by the rounding of the rest
} pair;

static double absolute_dot(wide3 a, wide3 b) {
    return fabs(a.x) * b.x + fabs(a.y) * b.y + fabs(a.z) * b.z;
}

// Does a plane across the axis a part them? A rounded axis is as good as another.
static bool parts(const pair *k, wide3 a) {
    const double p = wide_dot(a, k->p[0]), q = wide_dot(a, k->p[1]), s = wide_dot(a, k->p[2]);
    const double reach = absolute_dot(a, k->half);
    return (p > reach && q > reach && s > reach) || (p < -reach && q < -reach && s < -reach);
}

static bool boxes_meet(aabb a, aabb b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y &&
           b.min.y <= a.max.y && a.min.z <= b.max.z && b.min.z <= a.max.z;
}

// Half a side; more than all roundings of coordinates as large as these.
static double half_side(real low, real high, real least, real most) {
    const double size =
        fabs((double)low) + fabs((double)high) + fabs((double)least) + fabs((double)most);
    return (double)high / 2 - (double)low / 2 + 8 * DBL_EPSILON * size;
}

static pair seen_from_middle(triangle T, aabb box, aabb cell) {
    const wide3 a = widen(cell.min), b = widen(cell.max);
    const wide3 c = {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
    return (pair){{wide_along(widen(T.p1), -1, c), wide_along(widen(T.p2), -1, c),
                   wide_along(widen(T.p3), -1, c)},
                  {half_side(cell.min.x, cell.max.x, box.min.x, box.max.x),
                   half_side(cell.min.y, cell.max.y, box.min.y, box.max.y),
                   half_side(cell.min.z, cell.max.z, box.min.z, box.max.z)}};
}

// Two convex bodies are apart when one of 13 axes says so: the cell's three normals, the
// triangle's, and the nine products of their edges.
bool cell_overlaps(triangle T, aabb cell) {
    const aabb box = aabb_of(T);
    if (!boxes_meet(box, cell)) return false;
    const pair k = seen_from_middle(T, box, cell);
    const wide3 e[3] = {wide_sub(T.p2, T.p1), wide_sub(T.p3, T.p2), wide_sub(T.p1, T.p3)};
    if (parts(&k, wide_cross(e[0], e[1]))) return false;
    for (int i = 0; i < 3; i++) {
        if (parts(&k, (wide3){0, -e[i].z, e[i].y})) return false;
        if (parts(&k, (wide3){e[i].z, 0, -e[i].x})) return false;
        if (parts(&k, (wide3){-e[i].y, e[i].x, 0})) return false;
    }
    return true;
}
