// Wrong: the low side of the box decides, not its centre.
// Expect: Below: <
#include "chapters/12-bvh/bvh.h"

int split_at(bvh_item *items, int count, int axis, real middle) {
    int low = 0, high = count;
    while (low < high) {
        const bvh_item item = items[low];
        if (along(item.box.min, axis) < middle) {
            low++;
        } else {
            items[low] = items[--high];
            items[high] = item;
        }
    }
    return low;
}
