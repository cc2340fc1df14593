// Wrong: worked out in float.
// Expect: too few digits
// Expect: double from beginning to end
#include "chapters/01-rasterize/rasterize.h"

double edge_function(raster_point a, raster_point b, double x, double y) {
    const float ax = (float)a.x, ay = (float)a.y, bx = (float)b.x, by = (float)b.y;
    return (by - ay) * ((float)x - ax) - (bx - ax) * ((float)y - ay);
}
