// Right: the low ones are gathered at the front, as in quicksort.
#include "chapters/12-bvh/bvh.h"

int split_at(bvh_item *items, int count, int axis, real middle) {
    int low = 0;
    for (int i = 0; i < count; i++) {
        if (!(along(aabb_centre(items[i].box), axis) < middle)) continue;
        const bvh_item item = items[i];
        items[i] = items[low];
        items[low++] = item;
    }
    return low;
}
