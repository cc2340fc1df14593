// Wrong: half a pixel is added to a point that already is the centre.
// Expect: half a pixel was added
#include "chapters/02-camera/camera.h"

ray camera_ray(const camera *cam, real x, real y) {
    const vec3 across = scale(x + (real)0.5 - (real)cam->width / 2, cam->right);
    const vec3 upwards = scale((real)cam->height / 2 - y - (real)0.5, cam->up);
    return (ray){cam->eye, add(add(across, upwards), scale(cam->focal, cam->forward))};
}
