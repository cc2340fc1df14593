// Wrong: the basis is ignored: right, up and forward are taken to be x, y and -z.
// Expect: camera_ray: a turned camera
// Expect: camera_ray: 3000 generic cameras
// Expect: the camera is turned
#include "chapters/02-camera/camera.h"

ray camera_ray(const camera *cam, real x, real y) {
    const vec3 d = {x - (real)cam->width / 2, (real)cam->height / 2 - y, -cam->focal};
    return (ray){cam->eye, d};
}
