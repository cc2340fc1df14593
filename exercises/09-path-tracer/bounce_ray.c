// bounce_ray: the rendering equation with one random direction. The task is in README.md.
#include "chapters/09-path-tracer/path.h"
#include "common/todo.h"

color bounce_ray(const room *sc, const matte *m, ray r, hit h, int s, rng *g) {
    TODO("bounce_ray"); // your answer instead of these two lines
    return emitted(m, h);
}
