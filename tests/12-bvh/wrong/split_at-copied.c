// Wrong: an item is overwritten, not swapped.
// Expect: every item is there once, as it was
#include "chapters/12-bvh/bvh.h"

int split_at(bvh_item *items, int count, int axis, real middle) {
    int low = 0, high = count;
    while (low < high) {
        const bvh_item item = items[low];
        if (along(aabb_centre(item.box), axis) < middle) {
            low++;
        } else {
            items[low] = items[--high];
        }
    }
    return low;
}
