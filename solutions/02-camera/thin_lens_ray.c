#include "chapters/02-camera/camera.h"

ray thin_lens_ray(const camera *cam, real x, real y, real u, real v) {
    const ray pinhole = camera_ray(cam, x, y);
    const vec3 sharp =
        scale(cam->focus / cam->focal, pinhole.d); // from the eye, in the plane of focus
    const vec3 lens =
        add(scale(cam->lens_radius * u, cam->right), scale(cam->lens_radius * v, cam->up));
    return (ray){add(cam->eye, lens), sub(sharp, lens)};
}
