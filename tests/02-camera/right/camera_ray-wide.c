// Right: in double throughout, each component rounded once.
#include "chapters/02-camera/camera.h"
#include "common/wide3.h"

ray camera_ray(const camera *cam, real x, real y) {
    const double a = (double)x - cam->width * 0.5, b = cam->height * 0.5 - (double)y;
    wide3 d = {0, 0, 0};
    d = wide_along(d, a, widen(cam->right));
    d = wide_along(d, b, widen(cam->up));
    d = wide_along(d, (double)cam->focal, widen(cam->forward));
    return (ray){cam->eye, narrow(d)};
}
