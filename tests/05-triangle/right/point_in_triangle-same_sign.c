// Right: the three edges agree, whichever way n points.
#include "chapters/05-triangle/triangle.h"

static real side(vec3 a, vec3 b, vec3 p, vec3 n) {
    return dot(n, cross(sub(b, a), sub(p, a)));
}

bool point_in_triangle(vec3 p, triangle T, vec3 n) {
    const real a = side(T.p1, T.p2, p, n), b = side(T.p2, T.p3, p, n);
    const real c = side(T.p3, T.p1, p, n);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}
