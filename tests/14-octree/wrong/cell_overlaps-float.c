// Wrong: in real arithmetic, with no room for rounding: what touches is lost.
// Expect: they touch in one point
#include "chapters/14-octree/octree.h"

static bool parts(triangle T, aabb cell, vec3 a) {
    const vec3 c = aabb_centre(cell), half = scale((real)0.5, sub(cell.max, cell.min));
    const real p = dot(a, sub(T.p1, c)), q = dot(a, sub(T.p2, c)), s = dot(a, sub(T.p3, c));
    const real reach = dot(absolute(a), half) * (1 - 4 * REAL_EPSILON);
    return (p > reach && q > reach && s > reach) || (p < -reach && q < -reach && s < -reach);
}

bool cell_overlaps(triangle T, aabb cell) {
    const vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const vec3 e[3] = {sub(T.p2, T.p1), sub(T.p3, T.p2), sub(T.p1, T.p3)};
    if (parts(T, cell, cross(e[0], e[1]))) return false;
    for (int k = 0; k < 3; k++) {
        if (parts(T, cell, axes[k])) return false;
        for (int i = 0; i < 3; i++)
            if (parts(T, cell, cross(axes[k], e[i]))) return false;
    }
    return true;
}
