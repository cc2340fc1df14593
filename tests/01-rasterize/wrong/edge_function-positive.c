// Wrong: an area without a sign.
// Expect: never negative: fabs?
#include "chapters/01-rasterize/rasterize.h"

double edge_function(raster_point a, raster_point b, double x, double y) {
    return fabs((b.y - a.y) * (x - a.x) - (b.x - a.x) * (y - a.y));
}
