// Wrong: span is taken as the width of the picture.
// Expect: it is the height
#include "chapters/02-camera/camera.h"

ray orthographic_ray(const camera *cam, real x, real y) {
    const real pixel = cam->span / cam->width;
    const vec3 across = scale((x - (real)cam->width / 2) * pixel, cam->right);
    const vec3 upwards = scale(((real)cam->height / 2 - y) * pixel, cam->up);
    return (ray){add(cam->eye, add(across, upwards)), cam->forward};
}
