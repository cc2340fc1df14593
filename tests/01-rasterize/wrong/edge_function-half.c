// Wrong: the area, where twice the area is promised.
// Expect: the area, not twice the area
#include "chapters/01-rasterize/rasterize.h"

double edge_function(raster_point a, raster_point b, double x, double y) {
    return ((b.y - a.y) * (x - a.x) - (b.x - a.x) * (y - a.y)) / 2;
}
