// Wrong: nothing is asked: parallel vectors give 0/0.
// Expect: NaN
#include "chapters/02-camera/camera.h"

vec3 camera_right(vec3 forward, vec3 up) {
    return normalize(cross(forward, up));
}
