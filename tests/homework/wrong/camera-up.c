// Wrong: (0, 1, 0) itself for the upward axis of the camera.
// Expect: the camera's upward axis is (0, 1, 0) itself
// Stage: normal
#include "solutions/homework/raytracer.h"

ray camera_ray(const scene *sc, real x, real y) {
    const vec3 forward = normalize(sub(sc->target, sc->eye)), up = {0, 1, 0};
    const vec3 right = normalize(cross(forward, up));
    const real half = tan(sc->fov * (real)(PI / 360));
    const real across = (2 * x - WIDTH) / HEIGHT * half, upwards = (1 - 2 * y / HEIGHT) * half;
    return (ray){sc->eye,
                 normalize(add(forward, add(scale(across, right), scale(upwards, up))))};
}
