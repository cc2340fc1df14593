// child_of: in which child does a point lie? The task is in README.md.
#include "chapters/14-octree/octree.h"
#include "common/todo.h"

int child_of(vec3 p, vec3 middle) {
    TODO("child_of"); // your answer instead of these two lines
    return 0;
}
