// Wrong: the other axis may be parallel to the view as well.
// Expect: NaN
// Expect: camera_right: up parallel to the view
#include "chapters/02-camera/camera.h"

vec3 camera_right(vec3 forward, vec3 up) {
    const vec3 right = cross(forward, up);
    if (length(right) < (real)1e-6) return normalize(cross(forward, (vec3){1, 0, 0}));
    return normalize(right);
}
