// Right: without camera_ray: the sharp point is written out in the basis.
#include "chapters/02-camera/camera.h"

ray thin_lens_ray(const camera *cam, real x, real y, real u, real v) {
    const real unit = cam->focus / cam->focal; // of a pixel in the plane in focus
    const real lens_x = u * cam->lens_radius, lens_y = v * cam->lens_radius;
    const real a = (x - (real)cam->width / 2) * unit, b = ((real)cam->height / 2 - y) * unit;
    const vec3 start = add(scale(lens_x, cam->right), scale(lens_y, cam->up));
    const vec3 d = add(add(scale(a - lens_x, cam->right), scale(b - lens_y, cam->up)),
                       scale(cam->focus, cam->forward));
    return (ray){add(cam->eye, start), d};
}
