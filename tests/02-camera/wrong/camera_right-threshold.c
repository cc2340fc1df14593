// Wrong: an absolute threshold, which also takes a short up for a parallel one.
// Expect: Only what is parallel within rounding
// Expect: a thousandth is not parallel
#include "chapters/02-camera/camera.h"

vec3 camera_right(vec3 forward, vec3 up) {
    const vec3 right = cross(forward, up), a = absolute(forward);
    if (length(right) > (real)0.01) return normalize(right);
    const vec3 axis = a.x < a.y ? (vec3){1, 0, 0} : (vec3){0, 1, 0};
    return normalize(cross(forward, axis));
}
