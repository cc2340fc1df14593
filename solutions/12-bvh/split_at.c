#include "chapters/12-bvh/bvh.h"

static bool below(const bvh_item *item, int axis, real middle) {
    return along(aabb_centre(item->box), axis) < middle;
}

// From both ends: only what stands on the wrong side is moved.
int split_at(bvh_item *items, int count, int axis, real middle) {
    int low = 0, high = count;
    for (;;) {
        while (low < high && below(&items[low], axis, middle)) low++;
        while (low < high && !below(&items[high - 1], axis, middle)) high--;
        if (low == high) return low;
        const bvh_item item = items[low];
        items[low++] = items[--high];
        items[high] = item;
    }
}
