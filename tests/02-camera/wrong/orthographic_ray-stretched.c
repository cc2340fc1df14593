// Wrong: span is given to the width and to the height, so pixels are not square.
// Expect: pixels are square
#include "chapters/02-camera/camera.h"

ray orthographic_ray(const camera *cam, real x, real y) {
    const real pixel = cam->span / cam->width;
    const vec3 across = scale((x - (real)cam->width / 2) * pixel, cam->right);
    const vec3 upwards =
        scale(((real)cam->height / 2 - y) * (cam->span / cam->height), cam->up);
    return (ray){add(cam->eye, add(across, upwards)), cam->forward};
}
