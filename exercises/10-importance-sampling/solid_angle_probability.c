// solid_angle_probability: from area to solid angle. The task is in README.md.
#include "chapters/10-importance-sampling/importance.h"
#include "common/todo.h"
#include "common/wide3.h"

real solid_angle_probability(vec3 x, vec3 y, vec3 n_y, real area) {
    TODO("solid_angle_probability"); // your answer instead of these two lines
    return 0;
}
