// Wrong: the rays still fan out from the pixel, as those of a pinhole do.
// Expect: here all are parallel
#include "chapters/02-camera/camera.h"

ray orthographic_ray(const camera *cam, real x, real y) {
    const real pixel = cam->span / cam->height;
    const vec3 across = scale((x - (real)cam->width / 2) * pixel, cam->right);
    const vec3 upwards = scale(((real)cam->height / 2 - y) * pixel, cam->up);
    return (ray){add(cam->eye, add(across, upwards)), camera_ray(cam, x, y).d};
}
