// bvh_refit: the mesh has moved. The task is in README.md.
#include "chapters/12-bvh/bvh.h"
#include "common/todo.h"

void bvh_refit(bvh *b) {
    TODO("bvh_refit"); // your answer instead of this line
}
