// Right: as if every pixel's centre were moved a little to the right, and far less
// down: then no centre lies on an edge.
#include "chapters/01-rasterize/rasterize.h"

bool owns_edge(raster_point a, raster_point b) {
    const double dx = b.x - a.x, dy = b.y - a.y; // edge_function grows by dy to the right
    if (dy != 0) return dy > 0;
    return dx < 0; // and by -dx downwards
}
