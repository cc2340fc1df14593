// kd_split.c: candidate planes and what lies on their sides.
#include "chapters/13-kd-tree/kd_split.h"

#include <stdlib.h>

static void try_plane(kd_plane *best, aabb cell, int axis, real split, int below, int above,
                      kd_options how) {
    if (!(split > along(cell.min, axis) && split < along(cell.max, axis))) return;
    const real cost = kd_cost(cell, axis, split, below, above, how);
    if (cost < best->cost) *best = (kd_plane){cost, axis, split};
}

// ---- all of few ------------------------------------------------------------------------

// Where an item ends, lies flat or begins along the axis: in this order at one plane.
typedef struct {
    real at;
    enum { END, FLAT, BEGIN } what;
} event;

static int in_order(const void *a, const void *b) {
    const event *x = a, *y = b;
    if (x->at != y->at) return x->at < y->at ? -1 : 1;
    return (int)x->what - (int)y->what;
}

static int events_of(event *e, const bvh_item *items, int count, int axis) {
    int n = 0;
    for (int i = 0; i < count; i++) {
        const real low = along(items[i].box.min, axis), high = along(items[i].box.max, axis);
        if (low == high) {
            e[n++] = (event){low, FLAT};
        } else {
            e[n++] = (event){low, BEGIN};
            e[n++] = (event){high, END};
        }
    }
    qsort(e, (size_t)n, sizeof *e, in_order);
    return n;
}

// A plane goes through all events at one place. What ends there is no longer above, what
// begins not yet below, and what is flat below (kd_sides).
static void sweep(kd_plane *best, const bvh_item *items, int count, aabb cell, int axis,
                  kd_options how) {
    event e[2 * KD_FEW];
    const int n = events_of(e, items, count, axis);
    int below = 0, above = count;
    for (int i = 0; i < n;) {
        const real split = e[i].at;
        int begin = 0;
        for (; i < n && e[i].at == split; i++) {
            above -= e[i].what != BEGIN;
            below += e[i].what == FLAT;
            begin += e[i].what == BEGIN;
        }
        try_plane(best, cell, axis, split, below, above, how);
        below += begin;
    }
}

// ---- some of many ------------------------------------------------------------------------

// How many items begin and end between two planes.
typedef struct {
    int begin[KD_BINS], end[KD_BINS];
} bins;

static int bin_of(real x, real low, real per_length) {
    const real i = (x - low) * per_length;
    if (!(i > 0)) return 0;
    return i < KD_BINS ? (int)i : KD_BINS - 1;
}

static void bin_planes(kd_plane *best, const bvh_item *items, int count, aabb cell, int axis,
                       kd_options how) {
    const real low = along(cell.min, axis), width = along(cell.max, axis) - low,
               per_length = KD_BINS / width;
    if (!isfinite(per_length)) return;
    bins b = {{0}, {0}};
    real first = INFINITY, last = -INFINITY;
    for (int i = 0; i < count; i++) {
        const real from = along(items[i].box.min, axis), to = along(items[i].box.max, axis);
        b.begin[bin_of(from, low, per_length)]++;
        b.end[bin_of(to, low, per_length)]++;
        first = lesser(first, from);
        last = greater(last, to);
    }
    int below = 0, above = count;
    for (int i = 1; i < KD_BINS; i++) {
        below += b.begin[i - 1];
        above -= b.end[i - 1];
        try_plane(best, cell, axis, low + (real)i * width / KD_BINS, below, above, how);
    }
    try_plane(best, cell, axis, first, 0, count, how);
    try_plane(best, cell, axis, last, count, 0, how);
}

kd_plane kd_best_plane(const bvh_item *items, int count, aabb cell, kd_options how) {
    kd_plane best = {(real)C_HIT * (real)count, -1, 0};
    if (!(aabb_area(cell) > 0)) return best;
    for (int axis = 0; axis < 3; axis++) {
        if (count <= KD_FEW)
            sweep(&best, items, count, cell, axis, how);
        else
            bin_planes(&best, items, count, cell, axis, how);
    }
    return best;
}
