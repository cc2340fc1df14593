// edge_function: is the pixel inside? The task is in README.md.
#include "chapters/01-rasterize/rasterize.h"
#include "common/todo.h"

double edge_function(raster_point a, raster_point b, double x, double y) {
    TODO("edge_function"); // your answer instead of these two lines
    return 0;              // no area: no triangle fills anything
}
