// plane_hit: where does a ray meet a plane? The task is in README.md.
#include "chapters/03-plane/plane.h"
#include "common/todo.h"
#include "common/wide3.h"

real plane_hit(plane P, ray r, real t_min, real t_max) {
    TODO("plane_hit"); // your answer instead of these two lines
    return NO_HIT;
}
