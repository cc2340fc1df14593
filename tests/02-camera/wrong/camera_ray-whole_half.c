// Wrong: width / 2 is divided as whole numbers.
// Expect: 5 / 2 is 2
#include "chapters/02-camera/camera.h"

ray camera_ray(const camera *cam, real x, real y) {
    const vec3 across = scale(x - (real)(cam->width / 2), cam->right);
    const vec3 upwards = scale((real)(cam->height / 2) - y, cam->up);
    return (ray){cam->eye, add(add(across, upwards), scale(cam->focal, cam->forward))};
}
