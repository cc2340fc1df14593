// sweep.c: the surface area heuristic with every plane between two triangles.
#include <stdlib.h>

#include "chapters/12-bvh/split.h"
#include "common/die.h"

static int compare(const bvh_item *a, const bvh_item *b, int axis) {
    const real x = along(aabb_centre(a->box), axis), y = along(aabb_centre(b->box), axis);
    if (x != y) return x < y ? -1 : 1;
    return a->triangle < b->triangle ? -1 : 1;
}
static int by_x(const void *a, const void *b) {
    return compare(a, b, 0);
}
static int by_y(const void *a, const void *b) {
    return compare(a, b, 1);
}
static int by_z(const void *a, const void *b) {
    return compare(a, b, 2);
}

static void sort(bvh_item *items, int count, int axis) {
    qsort(items, (size_t)count, sizeof *items, axis == 0 ? by_x : axis == 1 ? by_y : by_z);
}

typedef struct {
    real cost;
    int axis, left;
} candidate;

// right[k] becomes the box of the sorted items k … count - 1.
static candidate cheapest(const bvh_item *items, int count, aabb *right, aabb box, int axis,
                          candidate best) {
    right[count - 1] = items[count - 1].box;
    for (int k = count - 2; k > 0; k--) right[k] = aabb_join(items[k].box, right[k + 1]);
    aabb left = aabb_empty;
    for (int k = 1; k < count; k++) {
        left = aabb_join(left, items[k - 1].box);
        const real c = sah_cost(box, k, left, count - k, right[k]);
        if (c < best.cost) best = (candidate){c, axis, k};
    }
    return best;
}

int split_by_sweep(bvh_item *items, int count, extent in, bvh_options how) {
    aabb *right = malloc((size_t)count * sizeof *right);
    if (!right) die(EXIT_RUN, "no memory to divide %d triangles", count);
    candidate best = {count <= how.leaf_size ? (real)C_HIT * (real)count : INFINITY, -1, 0};
    for (int axis = 0; axis < 3; axis++) {
        sort(items, count, axis);
        best = cheapest(items, count, right, in.box, axis, best);
    }
    free(right);
    if (best.axis < 0) return 0;
    sort(items, count, best.axis);
    return best.left;
}
