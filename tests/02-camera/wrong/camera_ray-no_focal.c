// Wrong: the image plane stands one pixel before the eye: focal is missing.
// Expect: forward has length 1, times focal
#include "chapters/02-camera/camera.h"

ray camera_ray(const camera *cam, real x, real y) {
    const vec3 across = scale(x - (real)cam->width / 2, cam->right);
    const vec3 upwards = scale((real)cam->height / 2 - y, cam->up);
    return (ray){cam->eye, add(add(across, upwards), cam->forward)};
}
