// owns_edge: who owns a pixel that lies exactly on an edge? The task is in README.md.
#include "chapters/01-rasterize/rasterize.h"
#include "common/todo.h"

bool owns_edge(raster_point a, raster_point b) {
    TODO("owns_edge"); // your answer instead of these two lines
    return false;
}
