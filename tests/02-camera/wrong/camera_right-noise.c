// Wrong: near parallel, what the float cross product leaves along forward stays in.
// Expect: rounding leaves a part along forward
#include "chapters/02-camera/camera.h"

vec3 camera_right(vec3 forward, vec3 up) {
    const real size = fmax(fabs(up.x), fmax(fabs(up.y), fabs(up.z)));
    const vec3 a = absolute(forward);
    if (is_finite(up) && size > 0) {
        const vec3 right = cross(forward, scale(1 / size, up));
        if (length(right) > 8 * REAL_EPSILON) return normalize(right);
    }
    const vec3 axis = a.x < a.y ? (vec3){1, 0, 0} : (vec3){0, 1, 0};
    return normalize(cross(forward, axis));
}
