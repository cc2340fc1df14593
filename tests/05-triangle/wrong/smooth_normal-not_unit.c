// Wrong: the mean of the normals is not made a unit vector.
// Expect: the weighted mean, not of unit length
#include "chapters/05-triangle/triangle.h"

vec3 smooth_normal(vec3 n1, vec3 n2, vec3 n3, real u, real v) {
    const vec3 n = add(add(scale(1 - u - v, n1), scale(u, n2)), scale(v, n3));
    return n;
}
