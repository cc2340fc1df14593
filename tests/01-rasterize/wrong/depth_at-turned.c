// Wrong: one edge is walked backwards, so its area has the other sign.
// Expect: one edge is turned
#include "chapters/01-rasterize/rasterize.h"

double depth_at(const raster_point p[3], double x, double y) {
    const double w0 = edge_function(p[1], p[2], x, y);
    const double w1 = edge_function(p[0], p[2], x, y);
    const double w2 = edge_function(p[0], p[1], x, y);
    return (w0 + w1 + w2) / (w0 / p[0].depth + w1 / p[1].depth + w2 / p[2].depth);
}
