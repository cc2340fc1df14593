// sphere_probability: the density that belongs to it. The task is in README.md.
#include "chapters/10-importance-sampling/importance.h"
#include "common/todo.h"
#include "common/wide3.h"

real sphere_probability(sphere S, vec3 x, vec3 v) {
    TODO("sphere_probability"); // your answer instead of these two lines
    return 0;
}
