// Right: from the top left corner of the picture, in steps of a pixel.
#include "chapters/02-camera/camera.h"

ray orthographic_ray(const camera *cam, real x, real y) {
    const real w = (real)cam->width / (real)cam->height * cam->span, h = cam->span;
    const real a = x / (real)cam->height * h - w / 2, b = h / 2 - y / (real)cam->height * h;
    const vec3 from_eye = add(scale(a, cam->right), scale(b, cam->up));
    return (ray){add(from_eye, cam->eye), cam->forward};
}
