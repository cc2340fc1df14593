// Wrong: sorts along x, whatever the axis.
// Expect: the boxes' centres decide
#include <stdlib.h>

#include "chapters/12-bvh/bvh.h"

static int by_x(const void *a, const void *b) {
    const real x = ((const bvh_item *)a)->box.min.x, y = ((const bvh_item *)b)->box.min.x;
    return (x > y) - (x < y);
}

void split_median(bvh_item *items, int count, int axis) {
    (void)axis; // and always along x
    qsort(items, (size_t)count, sizeof *items, by_x);
}
