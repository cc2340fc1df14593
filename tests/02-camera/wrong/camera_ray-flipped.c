// Wrong: y is taken to grow upwards, so the picture stands on its head.
// Expect: y grows downwards in the picture
#include "chapters/02-camera/camera.h"

ray camera_ray(const camera *cam, real x, real y) {
    const vec3 across = scale(x - (real)cam->width / 2, cam->right);
    const vec3 upwards = scale(y - (real)cam->height / 2, cam->up);
    return (ray){cam->eye, add(add(across, upwards), scale(cam->focal, cam->forward))};
}
