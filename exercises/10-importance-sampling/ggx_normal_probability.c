// ggx_normal_probability: the density that belongs to them. The task is in README.md.
#include "chapters/10-importance-sampling/ggx.h"
#include "common/todo.h"

real ggx_normal_probability(vec3 o, vec3 h, real alpha) {
    TODO("ggx_normal_probability"); // your answer instead of these two lines
    return 0;
}
