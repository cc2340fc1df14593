// Wrong: the sign of y forgotten: left edges and bottom edges.
// Expect: horizontal, to the left: a top edge
#include "chapters/01-rasterize/rasterize.h"

bool owns_edge(raster_point a, raster_point b) {
    return b.y > a.y || (b.y == a.y && b.x > a.x);
}
