// Right: the same area seen from the point, as the cross product of the ways to
// the two corners.
#include "chapters/01-rasterize/rasterize.h"

double edge_function(raster_point a, raster_point b, double x, double y) {
    return (b.x - x) * (a.y - y) - (a.x - x) * (b.y - y);
}
