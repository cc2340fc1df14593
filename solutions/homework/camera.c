// camera.c: the pinhole camera.
#include "solutions/homework/raytracer.h"

ray camera_ray(const scene *sc, real x, real y) {
    const vec3 forward = normalize(sub(sc->target, sc->eye));
    const vec3 right = normalize(cross(forward, (vec3){0, 1, 0}));
    const vec3 up = cross(right, forward);
    const real half = tan(sc->fov * (real)(PI / 360)); // the picture's height, one ahead
    const real across = (2 * x - WIDTH) / HEIGHT * half, upwards = (1 - 2 * y / HEIGHT) * half;
    const vec3 d = add(forward, add(scale(across, right), scale(upwards, up)));
    return (ray){sc->eye, normalize(d)};
}
