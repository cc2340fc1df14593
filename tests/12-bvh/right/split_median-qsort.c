// Right: sorts all.
#include <stdlib.h>

#include "chapters/12-bvh/bvh.h"

typedef struct {
    real centre;
    bvh_item item;
} keyed;

static int by_centre(const void *a, const void *b) {
    const real x = ((const keyed *)a)->centre, y = ((const keyed *)b)->centre;
    return (x > y) - (x < y);
}

void split_median(bvh_item *items, int count, int axis) {
    keyed *k = malloc((size_t)count * sizeof *k);
    if (!k) return;
    for (int i = 0; i < count; i++)
        k[i] = (keyed){along(aabb_centre(items[i].box), axis), items[i]};
    qsort(k, (size_t)count, sizeof *k, by_centre);
    for (int i = 0; i < count; i++) items[i] = k[i].item;
    free(k);
}
