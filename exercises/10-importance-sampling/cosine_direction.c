// cosine_direction: directions as Lambert's surface wants them. The task is in README.md.
#include "chapters/10-importance-sampling/importance.h"
#include "common/todo.h"

vec3 cosine_direction(vec3 n, rng *g) {
    TODO("cosine_direction"); // your answer instead of these two lines
    return n;
}
