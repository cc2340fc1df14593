// Wrong: x and y alone decide, so that a triangle in a plane of the z axis is a line.
// Expect: two coordinates are not enough in every plane
#include "chapters/05-triangle/triangle.h"

static real side(vec3 a, vec3 b, vec3 p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool point_in_triangle(vec3 p, triangle T, vec3 n) {
    (void)n;
    const real a = side(T.p1, T.p2, p), b = side(T.p2, T.p3, p), c = side(T.p3, T.p1, p);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}
