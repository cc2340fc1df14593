#include "chapters/12-bvh/bvh.h"

static void swap(bvh_item *a, bvh_item *b) {
    const bvh_item c = *a;
    *a = *b;
    *b = c;
}

static real key(const bvh_item *item, int axis) {
    return along(aabb_centre(item->box), axis);
}

// Hoare's selection: sorts only as far as needed, n steps instead of n log n. The middle one of
// three as pivot, and both sides stop at its equals: equal centres are halved, not quadratic.
void split_median(bvh_item *items, int count, int axis) {
    const int k = count / 2;
    int from = 0, to = count - 1;
    while (from < to) {
        const int mid = from + (to - from) / 2;
        if (key(&items[mid], axis) < key(&items[from], axis)) swap(&items[mid], &items[from]);
        if (key(&items[to], axis) < key(&items[mid], axis)) swap(&items[to], &items[mid]);
        if (key(&items[mid], axis) < key(&items[from], axis)) swap(&items[mid], &items[from]);
        const real pivot = key(&items[mid], axis);
        int i = from, j = to;
        while (i <= j) {
            while (key(&items[i], axis) < pivot) i++;
            while (pivot < key(&items[j], axis)) j--;
            if (i <= j) swap(&items[i++], &items[j--]);
        }
        if (k <= j)
            to = j;
        else if (k >= i)
            from = i;
        else
            return;
    }
}
