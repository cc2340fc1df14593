// triangle_sample: a uniform point of a triangle. The task is in README.md.
#include "chapters/10-importance-sampling/importance.h"
#include "common/todo.h"

triangle_point triangle_sample(triangle T, rng *g) {
    TODO("triangle_sample"); // your answer instead of these two lines
    return (triangle_point){0, 0, 0};
}
