// cell_overlaps: is a triangle in a cell? The task is in README.md.
#include "chapters/14-octree/octree.h"
#include "common/todo.h"

bool cell_overlaps(triangle T, aabb cell) {
    TODO("cell_overlaps"); // your answer instead of these two lines
    return false;
}
