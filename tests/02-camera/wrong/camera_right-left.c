// Wrong: the factors of the cross product are swapped: that is left.
// Expect: left: up x forward
#include "chapters/02-camera/camera.h"

vec3 camera_right(vec3 forward, vec3 up) {
    const vec3 left = cross(up, forward);
    return length(left) > 0 ? normalize(left) : normalize(cross(forward, (vec3){0, 0, 1}));
}
