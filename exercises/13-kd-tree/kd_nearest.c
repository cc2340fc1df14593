// kd_nearest: the walk. The task is in README.md.
#include "chapters/13-kd-tree/kd_leaf.h"
#include "common/todo.h"

triangle_point kd_nearest(const kd_tree *k, ray r, real t_min, real t_max, int *index,
                          effort *spent) {
    TODO("kd_nearest"); // your answer instead of these two lines
    return (triangle_point){NO_HIT, 0, 0};
}
