// kd_sides: which children hold a primitive. The task is in README.md.
#include "chapters/13-kd-tree/kd_tree.h"
#include "common/todo.h"

int kd_sides(aabb box, int axis, real split) {
    TODO("kd_sides"); // your answer instead of these two lines
    return KD_BELOW | KD_ABOVE;
}
