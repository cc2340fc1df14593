// Wrong: one of the two ways to the point begins in b.
// Expect: b in place of a in the way along y
#include "chapters/01-rasterize/rasterize.h"

double edge_function(raster_point a, raster_point b, double x, double y) {
    return (b.y - a.y) * (x - a.x) - (b.x - a.x) * (y - b.y);
}
