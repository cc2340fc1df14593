// Wrong: multiplied out, so that far from the origin large products cancel.
// Expect: subtract corners before you multiply
#include "chapters/01-rasterize/rasterize.h"

double edge_function(raster_point a, raster_point b, double x, double y) {
    return b.y * x - b.x * y + b.x * a.y - b.y * a.x + a.x * y - a.y * x;
}
