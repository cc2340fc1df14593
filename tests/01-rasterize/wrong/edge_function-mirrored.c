// Wrong: the textbook's formula, for a y axis that points up.
// Expect: positive on the right: y points down on the screen
#include "chapters/01-rasterize/rasterize.h"

double edge_function(raster_point a, raster_point b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}
