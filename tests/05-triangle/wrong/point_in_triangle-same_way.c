// Wrong: asks whether the cross products point the same way, and lets one of them be 0.
// Expect: On the line through an edge its cross product is 0
#include "chapters/05-triangle/triangle.h"

bool point_in_triangle(vec3 p, triangle T, vec3 n) {
    (void)n;
    const vec3 c1 = cross(sub(T.p2, T.p1), sub(p, T.p1));
    const vec3 c2 = cross(sub(T.p3, T.p2), sub(p, T.p2));
    const vec3 c3 = cross(sub(T.p1, T.p3), sub(p, T.p3));
    return dot(c1, c2) >= 0 && dot(c2, c3) >= 0;
}
