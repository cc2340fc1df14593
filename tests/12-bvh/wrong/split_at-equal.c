// Wrong: those at the middle go to the left, too.
// Expect: Below: <
#include "chapters/12-bvh/bvh.h"

int split_at(bvh_item *items, int count, int axis, real middle) {
    int low = 0, high = count;
    while (low < high) {
        const bvh_item item = items[low];
        if (along(aabb_centre(item.box), axis) <= middle) {
            low++;
        } else {
            items[low] = items[--high];
            items[high] = item;
        }
    }
    return low;
}
