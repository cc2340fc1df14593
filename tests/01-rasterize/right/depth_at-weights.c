// Right: two weights, and the third is what is missing to 1.
#include "chapters/01-rasterize/rasterize.h"

double depth_at(const raster_point p[3], double x, double y) {
    const double area = edge_function(p[0], p[1], p[2].x, p[2].y);
    const double u = edge_function(p[2], p[0], x, y) / area;
    const double v = edge_function(p[0], p[1], x, y) / area;
    const double i0 = 1 / p[0].depth, i1 = 1 / p[1].depth, i2 = 1 / p[2].depth;
    return 1 / (i0 + u * (i1 - i0) + v * (i2 - i0));
}
