#include "chapters/01-rasterize/rasterize.h"

bool owns_edge(raster_point a, raster_point b) {
    const bool left = b.y > a.y;              // going down, y down
    const bool top = b.y == a.y && b.x < a.x; // horizontal, going left
    return left || top;
}
