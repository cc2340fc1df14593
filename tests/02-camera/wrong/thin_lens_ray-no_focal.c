// Wrong: d is taken to count in units, so focus is not divided by focal.
// Expect: focus counts in units, d in pixels
#include "chapters/02-camera/camera.h"

ray thin_lens_ray(const camera *cam, real x, real y, real u, real v) {
    const ray pinhole = camera_ray(cam, x, y);
    const vec3 sharp = scale(cam->focus, pinhole.d);
    const vec3 lens = scale(cam->lens_radius, add(scale(u, cam->right), scale(v, cam->up)));
    return (ray){add(cam->eye, lens), sub(sharp, lens)};
}
