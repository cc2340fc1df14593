// Wrong: d is the point of the image plane, not the way there from the eye.
// Expect: d is a difference
#include "chapters/02-camera/camera.h"

ray camera_ray(const camera *cam, real x, real y) {
    const vec3 across = scale(x - (real)cam->width / 2, cam->right);
    const vec3 upwards = scale((real)cam->height / 2 - y, cam->up);
    const vec3 d = add(add(across, upwards), scale(cam->focal, cam->forward));
    return (ray){cam->eye, add(cam->eye, d)};
}
