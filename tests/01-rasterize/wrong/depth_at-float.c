// Wrong: the right formula in float.
// Expect: too few digits
// Expect: If only digits differ: double from beginning to end
#include "chapters/01-rasterize/rasterize.h"

double depth_at(const raster_point p[3], double x, double y) {
    const float w0 = (float)edge_function(p[1], p[2], x, y);
    const float w1 = (float)edge_function(p[2], p[0], x, y);
    const float w2 = (float)edge_function(p[0], p[1], x, y);
    const float d0 = (float)p[0].depth, d1 = (float)p[1].depth, d2 = (float)p[2].depth;
    return (w0 + w1 + w2) / (w0 / d0 + w1 / d1 + w2 / d2);
}
