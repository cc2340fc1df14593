// Wrong: quicksort by the first item: n² / 2 steps and as deep, when sorted or equal.
// Expect: split_median: 200,000 items in bad orders
#include "chapters/12-bvh/bvh.h"

static void swap(bvh_item *a, bvh_item *b) {
    const bvh_item c = *a;
    *a = *b;
    *b = c;
}

void split_median(bvh_item *items, int count, int axis) {
    if (count < 2) return;
    const real pivot = along(aabb_centre(items[0].box), axis);
    int last = 0;
    for (int i = 1; i < count; i++)
        if (along(aabb_centre(items[i].box), axis) < pivot) swap(&items[++last], &items[i]);
    swap(&items[0], &items[last]);
    split_median(items, last, axis);
    split_median(items + last + 1, count - last - 1, axis);
}
