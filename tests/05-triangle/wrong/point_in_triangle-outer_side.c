// Wrong: <= in the place of >=: the outer side of the edges.
// Expect: on the same side of all three edges
#include "chapters/05-triangle/triangle.h"

static bool inner_side(vec3 a, vec3 b, vec3 p, vec3 n) {
    return dot(cross(sub(b, a), sub(p, a)), n) <= 0;
}

bool point_in_triangle(vec3 p, triangle T, vec3 n) {
    return inner_side(T.p1, T.p2, p, n) && inner_side(T.p2, T.p3, p, n) &&
           inner_side(T.p3, T.p1, p, n);
}
