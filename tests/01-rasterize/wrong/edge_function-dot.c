// Wrong: the dot product of the edge with the way to the point.
// Expect: a dot product: it is zero straight across the edge
#include "chapters/01-rasterize/rasterize.h"

double edge_function(raster_point a, raster_point b, double x, double y) {
    return (b.x - a.x) * (x - a.x) + (b.y - a.y) * (y - a.y);
}
