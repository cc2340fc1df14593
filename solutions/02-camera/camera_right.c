#include "chapters/02-camera/camera.h"

// The axis least along v, made perpendicular to it.
static vec3 any_perpendicular(vec3 v) {
    const vec3 a = absolute(v);
    if (a.x <= a.y && a.x <= a.z) return cross(v, (vec3){1, 0, 0});
    return a.y <= a.z ? cross(v, (vec3){0, 1, 0}) : cross(v, (vec3){0, 0, 1});
}

vec3 camera_right(vec3 forward, vec3 up) {
    const real size = fmax(fabs(up.x), fmax(fabs(up.y), fabs(up.z)));
    if (!(size > 0)) return normalize(any_perpendicular(forward));
    const vec3 right = cross(forward, scale(1 / size, up));
    // Below a few roundings the cross product is only noise.
    if (length(right) < 8 * REAL_EPSILON) return normalize(any_perpendicular(forward));
    return normalize(right);
}
