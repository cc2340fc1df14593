// Wrong: the half is rounded up: the first count - count / 2 are the smallest.
// Expect: The first count / 2 on one side
#include "chapters/12-bvh/bvh.h"
#include "common/rng.h"

static void swap(bvh_item *a, bvh_item *b) {
    const bvh_item c = *a;
    *a = *b;
    *b = c;
}

static real key(const bvh_item *item, int axis) {
    return along(aabb_centre(item->box), axis);
}

void split_median(bvh_item *items, int count, int axis) {
    rng g = rng_seed(12, (uint64_t)count);
    const int k = (count + 1) / 2 < count ? (count + 1) / 2 : 0;
    int from = 0, to = count - 1;
    while (from < to) {
        const uint32_t within = rng_bits(&g) % (uint32_t)(to - from + 1);
        const real pivot = key(&items[from + (int)within], axis);
        int i = from, j = to;
        while (i <= j) {
            while (key(&items[i], axis) < pivot) i++;
            while (pivot < key(&items[j], axis)) j--;
            if (i <= j) swap(&items[i++], &items[j--]);
        }
        if (k > j && k < i) return;
        if (k <= j)
            to = j;
        else
            from = i;
    }
}
