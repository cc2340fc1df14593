// Wrong: every point is inside.
// Expect: Edges and corners belong to the triangle
#include "chapters/05-triangle/triangle.h"

bool point_in_triangle(vec3 p, triangle T, vec3 n) {
    (void)p, (void)T, (void)n;
    return true;
}
