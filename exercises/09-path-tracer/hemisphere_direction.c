// hemisphere_direction: a random direction on one side. The task is in README.md.
#include "chapters/09-path-tracer/path.h"
#include "common/todo.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    TODO("hemisphere_direction"); // your answer instead of these two lines
    return n;
}
