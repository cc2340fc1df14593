// Right: sorts by a heap, in place.
#include "chapters/12-bvh/bvh.h"

static void sink(bvh_item *items, int i, int count, int axis) {
    const bvh_item item = items[i];
    const real c = along(aabb_centre(item.box), axis);
    for (int k; (k = 2 * i + 1) < count; i = k) {
        const real left = along(aabb_centre(items[k].box), axis);
        const real right = k + 1 < count ? along(aabb_centre(items[k + 1].box), axis) : left;
        if (right > left) k++;
        if (c >= greater(left, right)) break;
        items[i] = items[k];
    }
    items[i] = item;
}

void split_median(bvh_item *items, int count, int axis) {
    for (int i = count / 2 - 1; i >= 0; i--) sink(items, i, count, axis);
    for (int n = count - 1; n > 0; n--) {
        const bvh_item largest = items[0];
        items[0] = items[n];
        items[n] = largest;
        sink(items, 0, n, axis);
    }
}
