// cylinder_hit: where does a ray meet an open tube? The task is in README.md.
#include "chapters/04-sphere/sphere.h"
#include "common/todo.h"

real cylinder_hit(cylinder C, ray r, real t_min, real t_max) {
    TODO("cylinder_hit"); // your answer instead of these two lines
    return NO_HIT;
}
