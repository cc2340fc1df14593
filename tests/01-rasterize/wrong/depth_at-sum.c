// Wrong: the weighted sum of 1/depth is returned as it is.
// Expect: neither divided by the whole area nor inverted
#include "chapters/01-rasterize/rasterize.h"

double depth_at(const raster_point p[3], double x, double y) {
    const double w0 = edge_function(p[1], p[2], x, y);
    const double w1 = edge_function(p[2], p[0], x, y);
    const double w2 = edge_function(p[0], p[1], x, y);
    return w0 / p[0].depth + w1 / p[1].depth + w2 / p[2].depth;
}
