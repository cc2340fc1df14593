// child_index: how many stored children stand before one? The task is in README.md.
#include "chapters/14-octree/octree.h"
#include "common/todo.h"

int child_index(unsigned mask, int i) {
    TODO("child_index"); // your answer instead of these two lines
    return 0;
}
