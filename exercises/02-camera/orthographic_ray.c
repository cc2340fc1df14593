// orthographic_ray: a camera without perspective. The task is in README.md.
#include "chapters/02-camera/camera.h"
#include "common/todo.h"

ray orthographic_ray(const camera *cam, real x, real y) {
    TODO("orthographic_ray"); // your answer instead of these two lines
    return (ray){cam->eye, cam->forward};
}
