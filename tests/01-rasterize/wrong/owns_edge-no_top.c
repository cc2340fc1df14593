// Wrong: only left edges; a pixel on a horizontal edge has no owner.
// Expect: horizontal, to the left: a top edge
#include "chapters/01-rasterize/rasterize.h"

bool owns_edge(raster_point a, raster_point b) {
    return b.y > a.y;
}
