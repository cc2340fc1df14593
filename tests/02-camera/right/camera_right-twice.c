// Right: the part along forward is taken away twice, in real alone; up is turned out of the way when it says nothing.
#include "chapters/02-camera/camera.h"

static vec3 without(vec3 v, vec3 forward) {
    return normalize(sub(v, scale(dot(v, forward), forward)));
}

vec3 camera_right(vec3 forward, vec3 up) {
    const real size = fmax(fabs(up.x), fmax(fabs(up.y), fabs(up.z)));
    vec3 right = {0, 0, 0};
    if (is_finite(up) && size > 0)
        right = cross(forward, (vec3){up.x / size, up.y / size, up.z / size});
    if (length(right) < 8 * REAL_EPSILON) {
        // The smallest component's axis, negated: any perpendicular will do.
        const vec3 a = absolute(forward);
        right = a.z <= a.x && a.z <= a.y ? (vec3){0, 0, -1}
                : a.y <= a.x             ? (vec3){0, -1, 0}
                                         : (vec3){-1, 0, 0};
    }
    right = without(normalize(right), forward);
    return without(right, forward);
}
