// Wrong: inserts one after the other: n² / 4 steps in no order.
// Expect: endless loop? stopped
#include "chapters/12-bvh/bvh.h"

void split_median(bvh_item *items, int count, int axis) {
    for (int i = 1; i < count; i++) {
        const bvh_item item = items[i];
        const real c = along(aabb_centre(item.box), axis);
        int k = i;
        for (; k > 0 && along(aabb_centre(items[k - 1].box), axis) > c; k--)
            items[k] = items[k - 1];
        items[k] = item;
    }
}
