#include "chapters/01-rasterize/rasterize.h"

// (b - a) x (p - a), negated because y points down.
double edge_function(raster_point a, raster_point b, double x, double y) {
    return (b.y - a.y) * (x - a.x) - (b.x - a.x) * (y - a.y);
}
