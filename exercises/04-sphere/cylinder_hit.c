// cylinder_hit: where does a ray meet an open tube? The task is in README.md.
#include "chapters/04-sphere/sphere.h"
#include "common/todo.h"
#include "common/wide3.h"

real cylinder_hit(cylinder C, ray r, real t_min, real t_max) {
    TODO("cylinder_hit"); // your answer instead of these two lines
    return NO_HIT;
}
