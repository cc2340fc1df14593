// split.c: the median, the midpoint, and the surface area heuristic with bins.
#include "chapters/12-bvh/split.h"

extent items_extent(const bvh_item *items, int count) {
    extent e = {aabb_empty, aabb_empty};
    for (int i = 0; i < count; i++) {
        e.box = aabb_join(e.box, items[i].box);
        e.centres = aabb_with(e.centres, aabb_centre(items[i].box));
    }
    return e;
}

int longest_axis(aabb box) {
    const vec3 e = sub(box.max, box.min);
    if (e.x >= e.y && e.x >= e.z) return 0;
    return e.y >= e.z ? 1 : 2;
}

int split_by_median(bvh_item *items, int count, extent in, bvh_options how) {
    if (count <= how.leaf_size) return 0;
    split_median(items, count, longest_axis(in.centres));
    return count / 2;
}

int split_by_midpoint(bvh_item *items, int count, extent in, bvh_options how) {
    if (count <= how.leaf_size) return 0;
    const int axis = longest_axis(in.centres);
    return split_at(items, count, axis, along(aabb_centre(in.centres), axis)) % count;
}

// ---- bins --------------------------------------------------------------------------

// What has its centre between two planes.
typedef struct {
    aabb box;
    int count;
} bin;

// Planes that cut the centres' box into slices of the same width along each axis.
typedef struct {
    aabb centres;
    vec3 per_length; // slices per unit; 0 along an axis on which all centres are the same
    int count;       // of slices
} slices;

static real slices_per(real length, int count) {
    const real s = (real)count * (1 - 2 * REAL_EPSILON) / length; // the last one holds its end
    return length > 0 && isfinite(s) ? s : 0;
}

static slices slices_of(aabb centres, int count) {
    const vec3 e = sub(centres.max, centres.min);
    return (slices){centres,
                    {slices_per(e.x, count), slices_per(e.y, count), slices_per(e.z, count)},
                    count};
}

static void bin_add(bin *b, aabb box) {
    b->box = aabb_join(b->box, box);
    b->count++;
}

static void fill_bins(bin bins[3][BVH_BINS], const bvh_item *items, int count, slices s) {
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < s.count; k++) bins[axis][k] = (bin){aabb_empty, 0};
    for (int i = 0; i < count; i++) {
        const aabb box = items[i].box;
        const vec3 at = mul(sub(aabb_centre(box), s.centres.min), s.per_length);
        bin_add(&bins[0][(int)at.x], box);
        bin_add(&bins[1][(int)at.y], box);
        bin_add(&bins[2][(int)at.z], box);
    }
}

typedef struct {
    real cost;
    int axis, slice; // what is in a slice below goes to the left
} candidate;

// The cheapest plane between two bins of an axis, when it is cheaper than `best`.
static candidate cheapest(const bin *bins, int count, aabb box, int axis, candidate best) {
    bin right[BVH_BINS], left = {aabb_empty, 0};
    right[count - 1] = bins[count - 1];
    for (int k = count - 2; k > 0; k--)
        right[k] =
            (bin){aabb_join(bins[k].box, right[k + 1].box), bins[k].count + right[k + 1].count};
    for (int k = 1; k < count; k++) {
        left = (bin){aabb_join(left.box, bins[k - 1].box), left.count + bins[k - 1].count};
        if (!left.count || !right[k].count) continue;
        const real c = sah_cost(box, left.count, left.box, right[k].count, right[k].box);
        if (c < best.cost) best = (candidate){c, axis, k};
    }
    return best;
}

// Few triangles need few bins, two of them only two.
static int bins_for(int count, bvh_options how) {
    if (count == 2) return 2;
    return count / 8 + 3 < how.bins ? count / 8 + 3 : how.bins;
}

static real plane_of(slices s, candidate c) {
    return along(s.centres.min, c.axis) + (real)c.slice / along(s.per_length, c.axis);
}

int split_by_bins(bvh_item *items, int count, extent in, bvh_options how) {
    if (!is_finite(sub(in.centres.max, in.centres.min))) return 0; // wider than real's range
    const slices s = slices_of(in.centres, bins_for(count, how));
    bin bins[3][BVH_BINS];
    fill_bins(bins, items, count, s);
    candidate best = {count <= how.leaf_size ? (real)C_HIT * (real)count : INFINITY, -1, 0};
    for (int axis = 0; axis < 3; axis++)
        if (along(s.per_length, axis) > 0)
            best = cheapest(bins[axis], s.count, in.box, axis, best);
    if (best.axis < 0) return 0;
    return split_at(items, count, best.axis, plane_of(s, best)) % count;
}
