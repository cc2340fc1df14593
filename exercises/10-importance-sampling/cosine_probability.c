// cosine_probability: the density that belongs to them. The task is in README.md.
#include "chapters/10-importance-sampling/importance.h"
#include "common/todo.h"

real cosine_probability(vec3 n, vec3 v) {
    TODO("cosine_probability"); // your answer instead of these two lines
    return 0;
}
